/** English for the path to learn and the ways to begin, which an empty program shows at once. */
export const LEARN_EN = {
  "learn.done-of": "{done} of {total} done",
  "learn.whole": "You have done the whole path. Well done!",
  "learn.next": "Next: {name}",
  "learn.learned": "done",
  "learn.tutorial": "Tutorial",
  "learn.exercise": "Exercise",
  "learn.invite": "Or learn step by step",
  "learn.all": "The whole path",
  "door.ways": "Ways to begin",
  "door.learn": "Learn",
  "door.learn-help": "Step by step, from easy to hard",
  "door.make": "Make",
  "door.make-help": "A new mission of your own",
  "door.look": "Look",
  "door.look-help": "Missions that are there",
  "graph.first-step": "Give the robot its first step",
  "graph.first-tap":
    "It follows the arrows from Start to End. Tap the dashed place to add a part, or begin with one of these:",
  "graph.first-help":
    "It follows the arrows from Start to End. Drag a part from the left onto the dashed place, or begin with one of these:",
  "exercise.broken": "This exercise cannot be used.",
  "tutorial.broken": "This tutorial cannot be used:",
  "tutorial.teachers": { one: "For teachers: {count} minute", other: "For teachers: {count} minutes" },
  "tutorial.troubles": "What goes wrong",
  "tutorial.questions": "Questions for afterwards",
} as const;
