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

/** ESLint: what changes is the state of a store, of an object or of a closure. A file that makes a store may have more beside it. */
export const moduleState = {
  meta: {
    type: "problem",
    messages: { loose: "{{name}} is state of a module: put it into a store, an object or a closure." },
    schema: [],
  },
  create(context) {
    const program = context.sourceCode.ast;
    const makesStore = program.body.some((one) => one.type === "ImportDeclaration" && one.source.value === "zustand");
    return {
      "Program > VariableDeclaration[kind='let'], Program > ExportNamedDeclaration > VariableDeclaration[kind='let']"(
        node,
      ) {
        if (makesStore) return;
        for (const { id } of node.declarations)
          context.report({ node, messageId: "loose", data: { name: context.sourceCode.getText(id) } });
      },
    };
  },
};
