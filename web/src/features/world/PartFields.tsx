/** The fields of one thing of the world, kind by kind. */
import type { ComponentType } from "react";

import { type Key, t } from "../../i18n/words";
import type { OwnWorld } from "../../model/types";
import { lineOf, startPlace } from "../../model/world/drawing";
import { nearestOn } from "../../model/world/line";
import { withSections } from "../../model/world/roads";
import { type Kind, LARGEST_MM, type Part, partOf, type PartReference, tidy } from "../../model/world/part-reference";
import { withPart } from "../../model/world/part-edits";
import { Closed, Corners } from "./Corners";
import { BallFields, BoxFields, ZoneFields } from "./MiddledFields";
import { NumberField } from "./NumberField";
import { Choice, Colour, Count, Numbers, type PartProps, set } from "./part-fields";

function names(list: readonly { name: string }[]): [string, string][] {
  return list.map(({ name }) => [name, name]);
}

function DockFields(props: PartProps<Part<"dock">>) {
  const { world, part, keep } = props;
  return (
    <>
      <Numbers {...props} names={["at_mm", "reach_mm"]} />
      <div className="world-fields gap-m">
        <Choice
          label={t("world.kind-road")}
          testId="world-road"
          value={part.road}
          options={names(world.roads)}
          keep={(road) => keep({ ...part, road })}
        />
        <Choice
          label={t("world.kind-storehouse")}
          testId="world-storehouse"
          value={part.storehouse}
          options={names(world.storehouses)}
          keep={(storehouse) => keep({ ...part, storehouse })}
        />
        <Choice
          label={t("world.does")}
          testId="world-kind"
          value={part.kind}
          options={[
            ["load", t("world.load")],
            ["unload", t("world.unload")],
          ]}
          keep={(kind) => keep({ ...part, kind: kind === "load" ? "load" : "unload" })}
        />
        <Choice
          label={t("world.side")}
          testId="world-side"
          value={part.side}
          options={[
            ["left", t("world.left")],
            ["right", t("world.right")],
          ]}
          keep={(side) => keep({ ...part, side: side === "right" ? "right" : "left" })}
        />
      </div>
    </>
  );
}

/** The start somewhere else of another kind: at the nearest place of that kind. */
function startAt(world: OwnWorld, part: Part<"start">, at: Part<"start">["at"]): Part<"start"> {
  const place = startPlace(world, part) ?? { x: world.width_mm / 2, y: world.height_mm / 2, heading: 0 };
  const bare = { ...part, at, road: "", at_mm: 0, dock: "", storehouse: "", x_mm: 0, y_mm: 0, heading_deg: 0 };
  if (at === "dock") return { ...bare, dock: world.docks[0]?.name ?? "" };
  if (at === "storehouse") return { ...bare, storehouse: world.storehouses[0]?.name ?? "" };
  if (at === "pose") {
    const heading_deg = Math.round((place.heading * 180) / Math.PI);
    return { ...bare, x_mm: Math.round(place.x), y_mm: Math.round(place.y), heading_deg };
  }
  const road = world.roads[0];
  const line = road === undefined ? null : lineOf(road.points, road.closed);
  const along = line === null ? 0 : Math.round(nearestOn(line, place.x, place.y).at);
  return { ...bare, road: road?.name ?? "", at_mm: along };
}

function StartFields(props: PartProps<Part<"start">>) {
  const { world, part, keep } = props;
  const places: [string, string, boolean][] = [
    ["pose", t("world.on-floor"), true],
    ["road", t("world.kind-road"), world.roads.length > 0],
    ["dock", t("world.kind-dock"), world.docks.length > 0],
    ["storehouse", t("world.kind-storehouse"), world.storehouses.length > 0],
  ];
  const options = places.flatMap(([value, words, there]): [string, string][] => (there ? [[value, words]] : []));
  return (
    <>
      <div className="world-fields gap-m">
        <Choice
          label={t("world.where")}
          testId="world-where"
          value={part.at}
          options={options}
          keep={(at) => keep(startAt(world, part, at as Part<"start">["at"]))}
        />
        {part.at === "pose" ? (
          <NumberField
            label={t("world.heading")}
            unit="°"
            value={part.heading_deg}
            min={-360}
            max={360}
            step={5}
            testId="world-heading"
            keep={(heading_deg, stepped) => keep({ ...part, heading_deg: tidy(heading_deg) }, "heading", stepped)}
          />
        ) : (
          <Choice
            label={t(`world.kind-${part.at}` as Key)}
            testId={`world-${part.at}`}
            value={part[part.at]}
            options={names(world[`${part.at}s`])}
            keep={(name) => keep({ ...part, [part.at]: name })}
          />
        )}
      </div>
      {part.at === "pose" ? <Numbers {...props} names={["x_mm", "y_mm"]} least={-LARGEST_MM} /> : null}
      {part.at === "road" ? <Numbers {...props} names={["at_mm"]} /> : null}
    </>
  );
}

function RoadFields(props: PartProps<Part<"road">>) {
  const { world, thing, part } = props;
  return (
    <>
      <Numbers {...props} names={["width_mm"]} least={1} />
      <Closed {...props} />
      <Count
        label={t("world.sections")}
        value={part.sections.length}
        name="sections"
        keep={(count) => set(world, thing, withSections(world, thing.at, Math.min(count, 200)))}
      />
      <Corners {...props} />
    </>
  );
}

function HouseFields(props: PartProps<Part<"storehouse">>) {
  const { part, keep } = props;
  return (
    <>
      <Numbers {...props} names={["x_mm", "y_mm"]} least={-LARGEST_MM} />
      <Numbers {...props} names={["width_mm", "height_mm"]} least={1} />
      <div className="world-fields gap-m">
        <Count
          label={t("world.capacity")}
          value={part.capacity}
          name="capacity"
          keep={(capacity) => keep({ ...part, capacity })}
        />
        <Count label={t("world.stock")} value={part.stock} name="stock" keep={(stock) => keep({ ...part, stock })} />
      </div>
    </>
  );
}

const FIELDS: { readonly [K in Kind]: ComponentType<PartProps<Part<K>>> } = {
  wall: (props) => <Numbers {...props} names={["x1", "y1", "x2", "y2"]} least={-LARGEST_MM} />,
  floor: (props) => (
    <>
      <Colour {...props} />
      <Corners {...props} />
    </>
  ),
  line: (props) => (
    <>
      <Colour {...props} />
      <Numbers {...props} names={["width_mm"]} least={0.1} />
      <Closed {...props} />
      <Corners {...props} />
    </>
  ),
  road: RoadFields,
  storehouse: HouseFields,
  dock: DockFields,
  start: StartFields,
  box: BoxFields,
  ball: BallFields,
  zone: ZoneFields,
};

export function PartFields({ world, thing }: { world: OwnWorld; thing: PartReference }) {
  const part = partOf(world, thing);
  const Fields = FIELDS[thing.kind] as ComponentType<PartProps<Part<Kind>>>;
  if (part === undefined) return null;
  const keep = (after: Part<Kind>, what = "", stepped = false) =>
    set(world, thing, withPart(world, thing, after), what, stepped);
  return <Fields world={world} thing={thing} part={part} keep={keep} />;
}
