/**
 * The floors of the page: imports go down, a feature imports no other feature, and nothing goes round in a circle.
 *
 * What each floor holds is in ARCHITECTURE.md.
 */
const FLOORS = [
  ["main", "^src/main\\.tsx$"],
  ["site", "^src/site/"],
  ["app", "^src/app/"],
  ["features", "^src/features/"],
  ["components", "^src/components/"],
  ["session", "^src/session/"],
  ["model and api", "^src/(model|api)/"],
  ["ui", "^src/ui/"],
  ["theme", "^src/theme/"],
  ["i18n", "^src/i18n/"],
];
const TESTS = "\\.test\\.tsx?$|/testing/";

const upwards = FLOORS.slice(1).map(([name, path], at) => ({
  name: `${name} imports what lies above it`.replaceAll(" ", "-"),
  severity: "error",
  from: { path, pathNot: TESTS },
  to: { path: FLOORS.slice(0, at + 1).map(([, above]) => above) },
}));

export default {
  forbidden: [
    ...upwards,
    {
      name: "a-feature-imports-another",
      comment: "What two features need is in session, or, when it is drawn, in components.",
      severity: "error",
      from: { path: "^src/features/([^/]+)/", pathNot: TESTS },
      to: { path: "^src/features/", pathNot: "^src/features/$1/" },
    },
    {
      name: "app-knows-a-feature-beside-the-list",
      comment: "app/features.ts has the only list of features; the others in app read that list.",
      severity: "error",
      from: { path: "^src/(app/|main\\.tsx$)", pathNot: `^src/app/features\\.ts$|${TESTS}` },
      to: { path: "^src/features/" },
    },
    {
      name: "the-list-knows-the-inside-of-a-feature",
      comment: "A feature gives one value, which its index exports.",
      severity: "error",
      from: { path: "^src/app/features\\.ts$" },
      to: { path: "^src/features/", pathNot: "^src/features/[^/]+/index\\.tsx?$" },
    },
    {
      name: "the-model-imports-the-api",
      comment: "Only the shapes of the server, which are types and nothing else.",
      severity: "error",
      from: { path: "^src/model/", pathNot: TESTS },
      to: { path: "^src/api/", pathNot: "^src/api/generated\\.ts$" },
    },
    {
      name: "no-circle",
      severity: "error",
      from: { pathNot: TESTS },
      to: { circular: true, viaOnly: { dependencyTypesNot: ["type-only"] } },
    },
    {
      name: "not-found",
      severity: "error",
      from: {},
      to: { couldNotResolve: true, pathNot: "\\?raw$" },
    },
  ],
  options: {
    doNotFollow: { path: "node_modules" },
    tsPreCompilationDeps: true,
    tsConfig: { fileName: "tsconfig.app.json" },
    enhancedResolveOptions: { exportsFields: ["exports"], conditionNames: ["import", "types", "default"] },
  },
};
