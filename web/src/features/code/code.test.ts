import { describe, expect, it } from "vitest";

import { lllMarks } from "../../components/text/lll-marks";
import { activeLines, vertexAt, vertexOfLine } from "./spans";

/** Each word of the text with its colour: "*:loop [:loop …". */
function painted(text: string): string {
  return lllMarks(text)
    .map(({ from, to, look }) => `${text.slice(from, to)}:${look}`)
    .join(" ");
}

describe("the colours of LLL", () => {
  it("give a loop's marks and closers one colour, its condition another", () => {
    expect(painted("*(a.b(););")).toBe(
      "*:loop (:loop a:action .:action b:action (:action ):action ;:quiet ):loop ;:quiet",
    );
    expect(painted("*[Run.IsTrue()](a.b(5););")).toBe(
      "*:loop [:loop Run:test .:test IsTrue:test (:test ):test ]:loop (:loop a:action .:action b:action (:action 5:number ):action ;:quiet ):loop ;:quiet",
    );
  });

  it("count a repetition's number to the loop", () => {
    expect(painted("12*(BREAK;)")).toBe("12:loop *:loop (:loop BREAK:loop ;:quiet ):loop");
  });

  it("give both sides of a choice its colour", () => {
    expect(painted("[S.P()](;)!(;)")).toBe(
      "[:choice S:test .:test P:test (:test ):test ]:choice (:choice ;:quiet ):choice !:choice (:choice ;:quiet ):choice",
    );
  });

  it("give an event and WAIT the colour of choices", () => {
    expect(painted("<S.P()>()")).toContain("<:choice");
    expect(painted("WAIT(3)")).toBe("WAIT:choice (:choice 3:number ):choice");
  });

  it("give the bars, the commas between branches and ° the colour of parallels", () => {
    expect(painted("//(a.b(1,2);,°c.d()°;)")).toBe(
      "//:parallel (:parallel a:action .:action b:action (:action 1:number ,:quiet 2:number ):action ;:quiet ,:parallel °:parallel c:action .:action d:action (:action ):action °:parallel ;:quiet ):parallel",
    );
  });

  it("give a negation inside a condition the colour of tests", () => {
    expect(painted("[!(A.B()|C.D())](;)")).toBe(
      "[:choice !:test (:test A:test .:test B:test (:test ):test |:test C:test .:test D:test (:test ):test ):test ]:choice (:choice ;:quiet ):choice",
    );
  });

  it("leave what stands in a comment alone", () => {
    expect(painted("# *[x](\na.b()")).toBe("# *[x](:comment a:action .:action b:action (:action ):action");
  });

  it.each(["", ")", "]](", "*[", "°°°", "//", "12*", "a.", "[(](", "💥 ?"])("survive %j", (text) => {
    const marks = lllMarks(text);
    expect(marks.every(({ from, to }) => from < to && to <= text.length)).toBe(true);
  });

  it("are in the order of the text and never overlap", () => {
    const marks = lllMarks("*[a.b()&c.d(3)](//(e.f();,°g.h(1)°);[x.y()](z.w();)!(;)) # end");
    marks.forEach((mark, index) => {
      const next = marks[index + 1];
      if (next !== undefined) expect(mark.to).toBeLessThanOrEqual(next.from);
    });
  });
});

describe("the spans", () => {
  const spans = [
    { vertex: "loop", start: 0, end: 40, line: 1 },
    { vertex: "test", start: 2, end: 10, line: 1 },
    { vertex: "go", start: 15, end: 25, line: 2 },
  ];

  it("lead from a place to the innermost vertex", () => {
    expect(vertexAt(spans, 5)).toBe("test");
    expect(vertexAt(spans, 12)).toBe("loop");
    expect(vertexAt(spans, 99)).toBeNull();
  });

  it("lead from a line to the vertex that begins on it", () => {
    expect(vertexOfLine(spans, 1, 0)).toBe("loop");
    expect(vertexOfLine(spans, 2, 15)).toBe("go");
  });

  it("lead from a line of closers to what is around it", () => {
    expect(vertexOfLine(spans, 3, 38)).toBe("loop");
  });

  it("give the lines where threads stand", () => {
    const active = new Map([
      ["test", [2]],
      ["loop", [0]],
      ["gone", [7]],
    ]);
    expect(activeLines(spans, active)).toEqual(new Map([[1, [0, 2]]]));
  });
});
