import { expect, it } from "vitest";

import { addressOfExercise, readExerciseLink } from "./exercise-link";

it("reads exercise, class and code; a code is written in capitals", () => {
  expect(readExerciseLink("#exercise=Handed%20out%2Fa%20b.exercise.xml&class=5b%20%26%20c&code=abcdef")).toEqual({
    exercise: "Handed out/a b.exercise.xml",
    className: "5b & c",
    code: "ABCDEF",
  });
  expect(readExerciseLink("#exercise=x")).toEqual({ exercise: "x", className: "", code: "" });
});

it("reads what an address says, and leaves the rest of the address", () => {
  const address = addressOfExercise("https://school.example/kit/?token=no#mission=x", "example:a&b#c.exercise.xml");
  expect(address.startsWith("https://school.example/kit/?token=no#exercise=")).toBe(true);
  expect(readExerciseLink(new URL(address).hash)?.exercise).toBe("example:a&b#c.exercise.xml");
});

it.each(["", "#", "#mission=x", "#exercise", "#exercise=&class=x", `#exercise=${"%41".repeat(2000)}`, "#%E0%A4%A"])(
  "%s is none",
  (hash) => expect(readExerciseLink(hash)).toBeNull(),
);
