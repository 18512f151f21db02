/** The outline of a floor, a line or a road: its corners, and whether it is closed. */
import { type Key, t } from "../../i18n/words";
import type { Corner } from "../../model/types";
import { withClosed, withPoints } from "../../model/world/roads";
import { LARGEST_MM, type Part, tidy } from "../../model/world/part-reference";
import { useShown } from "../../session/simple-view";
import { Checkbox } from "../../ui/Checkbox";
import { Tool } from "../../ui/Tool";
import { NumberField } from "./NumberField";
import { type PartProps, set } from "./part-fields";

/** The corners of a floor, a line or a road: each with its place and radius; put in and taken out. */
export function Corners<P extends Part<"line"> | Part<"floor"> | Part<"road">>({ world, thing, part }: PartProps<P>) {
  const closed = thing.kind === "floor" || ("closed" in part && part.closed);
  const least = closed ? 3 : 2;
  const { points } = part;
  const places = useShown("places");
  const keep = (after: Corner[], what = "", stepped = false) =>
    set(world, thing, withPoints(world, thing, after), what, stepped);
  const insert = (at: number) => {
    const [a, b] = [points[at], points[(at + 1) % points.length]];
    if (a === undefined || b === undefined) return;
    const between =
      at === points.length - 1 && !closed
        ? { x: tidy(a.x + 100), y: a.y, radius: 0 }
        : { x: tidy((a.x + b.x) / 2), y: tidy((a.y + b.y) / 2), radius: 0 };
    keep([...points.slice(0, at + 1), between, ...points.slice(at + 1)]);
  };
  if (!places) return null;
  return (
    <fieldset className="world-corners">
      <legend>{t("world.corners")}</legend>
      {points.map((point, at) => (
        <div className="world-corner gap-xs" key={at}>
          <span className="world-corner-number muted tiny-text">{at + 1}</span>
          {(["x", "y", "radius"] as const).map((name) => (
            <NumberField
              key={name}
              label={t(`world.${name}` as Key)}
              unit=""
              value={point[name]}
              min={name === "radius" ? 0 : -LARGEST_MM}
              max={LARGEST_MM}
              testId={`world-corner-${String(at)}-${name}`}
              keep={(value, stepped) =>
                keep(
                  points.map((one, index) => (index === at ? { ...one, [name]: tidy(value) } : one)),
                  `${name}${String(at)}`,
                  stepped,
                )
              }
            />
          ))}
          <Tool
            small
            icon="plus"
            iconSize={14}
            label={t("world.corner-add", { number: at + 1 })}
            testId={`world-corner-${String(at)}-add`}
            onClick={() => insert(at)}
          />
          <Tool
            small
            icon="x"
            data-removes=""
            iconSize={14}
            label={t("world.corner-remove", { number: at + 1 })}
            testId={`world-corner-${String(at)}-remove`}
            disabled={points.length <= least}
            onClick={() => keep(points.filter((_, index) => index !== at))}
          />
        </div>
      ))}
    </fieldset>
  );
}

export function Closed<P extends Part<"line"> | Part<"road">>({ world, thing, part, keep }: PartProps<P>) {
  return (
    <Checkbox
      testId="world-closed"
      checked={part.closed}
      disabled={!part.closed && part.points.length < 3}
      set={(closed) => {
        if (thing.kind === "road") set(world, thing, withClosed(world, thing.at, closed));
        else keep({ ...part, closed });
      }}
    >
      {t("world.closed")}
    </Checkbox>
  );
}
