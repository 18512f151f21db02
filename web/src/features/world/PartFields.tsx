/** The fields of one thing of the world, kind by kind. */
import type { ComponentType } from "react";

import { type Key, t } from "../../i18n/words";
import type { OwnWorld } from "../../model/types";
import { lineOf, startPlace } from "../../model/world/drawn";
import { nearestOn } from "../../model/world/line";
import { withSections } from "../../model/world/roads";
import { type Kind, LARGEST_MM, type Part, partOf, type Thing, tidy } from "../../model/world/thing";
import { withPart } from "../../model/world/things";
import { Closed, Corners } from "./Corners";
import { NumberField } from "./NumberField";
import { ThingFields, ZoneFields } from "./MiddledFields";
import { Choice, Colour, Count, Numbers, type PartProps, set } from "./part-fields";

function names(list: readonly { name: string }[]): [string, string][] {
  return list.map(({ name }) => [name, name]);
}

function DockFields({ world, thing, part }: PartProps<Part<"dock">>) {
  const keep = (more: Partial<Part<"dock">>) => set(world, thing, withPart(world, thing, { ...part, ...more }));
  return (
    <>
      <Numbers world={world} thing={thing} part={part} names={["at_mm", "reach_mm"]} />
      <div className="world-fields gap-m">
        <Choice
          label={t("world.kind-road")}
          testId="world-road"
          value={part.road}
          options={names(world.roads)}
          keep={(road) => keep({ road })}
        />
        <Choice
          label={t("world.kind-storehouse")}
          testId="world-storehouse"
          value={part.storehouse}
          options={names(world.storehouses)}
          keep={(storehouse) => keep({ storehouse })}
        />
        <Choice
          label={t("world.does")}
          testId="world-kind"
          value={part.kind}
          options={[
            ["load", t("world.load")],
            ["unload", t("world.unload")],
          ]}
          keep={(kind) => keep({ kind: kind === "load" ? "load" : "unload" })}
        />
        <Choice
          label={t("world.side")}
          testId="world-side"
          value={part.side}
          options={[
            ["left", t("world.left")],
            ["right", t("world.right")],
          ]}
          keep={(side) => keep({ side: side === "right" ? "right" : "left" })}
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

function StartFields({ world, thing, part }: PartProps<Part<"start">>) {
  const keep = (more: Part<"start">, what = "", stepped = false) =>
    set(world, thing, withPart(world, thing, more), what, stepped);
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
      {part.at === "pose" ? (
        <Numbers world={world} thing={thing} part={part} names={["x_mm", "y_mm"]} least={-LARGEST_MM} />
      ) : null}
      {part.at === "road" ? <Numbers world={world} thing={thing} part={part} names={["at_mm"]} /> : null}
    </>
  );
}

function RoadFields({ world, thing, part }: PartProps<Part<"road">>) {
  return (
    <>
      <Numbers world={world} thing={thing} part={part} names={["width_mm"]} least={1} />
      <Closed world={world} thing={thing} part={part} />
      <Count
        label={t("world.sections")}
        value={part.sections.length}
        name="sections"
        keep={(count) => set(world, thing, withSections(world, thing.at, Math.min(count, 200)))}
      />
      <Corners world={world} thing={thing} part={part} />
    </>
  );
}

function HouseFields({ world, thing, part }: PartProps<Part<"storehouse">>) {
  const keep = (more: Partial<Part<"storehouse">>) => set(world, thing, withPart(world, thing, { ...part, ...more }));
  return (
    <>
      <Numbers world={world} thing={thing} part={part} names={["x_mm", "y_mm"]} least={-LARGEST_MM} />
      <Numbers world={world} thing={thing} part={part} names={["width_mm", "height_mm"]} least={1} />
      <div className="world-fields gap-m">
        <Count
          label={t("world.capacity")}
          value={part.capacity}
          name="capacity"
          keep={(capacity) => keep({ capacity })}
        />
        <Count label={t("world.stock")} value={part.stock} name="stock" keep={(stock) => keep({ stock })} />
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
  box: ThingFields,
  ball: ThingFields,
  zone: ZoneFields,
};

export function PartFields({ world, thing }: { world: OwnWorld; thing: Thing }) {
  const part = partOf(world, thing);
  const Fields = FIELDS[thing.kind] as ComponentType<PartProps<Part<Kind>>>;
  return part === undefined ? null : <Fields world={world} thing={thing} part={part} />;
}
