/** ESLint: a store is changed in the file that makes it. Who reads it elsewhere calls a function of that file. */
export const ownStore = {
  meta: {
    type: "problem",
    messages: { foreign: "{{store}} is changed in the file that makes it: call a function of that file." },
    schema: [],
  },
  create: (context) => ({
    "MemberExpression[property.name='setState'][object.type='Identifier']"(node) {
      const { name } = node.object;
      for (let scope = context.sourceCode.getScope(node); scope !== null; scope = scope.upper) {
        const variable = scope.set.get(name);
        if (variable === undefined) continue;
        const imported = variable.defs.some(({ type }) => type === "ImportBinding");
        if (imported) context.report({ node, messageId: "foreign", data: { store: name } });
        return;
      }
    },
  }),
};
