/**
 * An ESLint rule: words that people read come from `i18n` in their language, so none stand in a drawing as English text.
 * Two words in a row are a sentence; single ones may be names, keys and endings of files, as everything in `code` may be.
 */
const SENTENCE = /[A-Za-z]{2,}\s+[A-Za-z]{2,}/;
const SHOWN = new Set(["alt", "aria-label", "aria-valuetext", "help", "label", "placeholder", "title"]);
const CODE = new Set(["code", "kbd", "pre", "style"]);

export const spokenWords = {
  meta: {
    type: "problem",
    messages: { said: "Say this with t(…) from i18n: it is read in each language." },
    schema: [],
  },
  create(context) {
    const check = (node, text) => {
      if (SENTENCE.test(text)) context.report({ node, messageId: "said" });
    };
    return {
      JSXText(node) {
        if (!CODE.has(node.parent.openingElement?.name.name)) check(node, node.value);
      },
      JSXAttribute(node) {
        const given = node.value?.type === "JSXExpressionContainer" ? node.value.expression : node.value;
        if (!SHOWN.has(node.name.name) || given === null || given === undefined) return;
        if (given.type === "Literal" && typeof given.value === "string") check(node, given.value);
        if (given.type === "TemplateLiteral") check(node, given.quasis.map(({ value }) => value.raw).join(" "));
      },
    };
  },
};
