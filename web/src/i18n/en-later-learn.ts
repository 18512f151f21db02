/** English for the path to learn and the ways to begin. */
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
} as const;
