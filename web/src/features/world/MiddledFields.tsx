/** The fields of what lies around its middle: boxes, balls and zones. */
import { type Key, t } from "../../i18n/words";
import { LARGEST_MM, type Part, tidy } from "../../model/world/thing";
import { withPart } from "../../model/world/things";
import { NumberField } from "./NumberField";
import { Choice, Numbers, type PartProps, set } from "./part-fields";

const [HEAVIEST_G, ROUGHEST] = [1_000_000, 10];
const KINDS = ["warm", "loud", "bright"] as const;
/** What a zone measures less than of a world says nothing of its shape. */
const LEAST_MM = 1;

function Place({ world, thing, part }: PartProps<Part<"box"> | Part<"ball"> | Part<"zone">>) {
  return <Numbers world={world} thing={thing} part={part} names={["x_mm", "y_mm"]} least={-LARGEST_MM} />;
}

export function ThingFields({ world, thing, part }: PartProps<Part<"box"> | Part<"ball">>) {
  const keep = (more: Partial<typeof part>, what: string, stepped: boolean) =>
    set(world, thing, withPart(world, thing, { ...part, ...more }), what, stepped);
  return (
    <>
      <Place world={world} thing={thing} part={part} />
      {"radius_mm" in part ? (
        <Numbers world={world} thing={thing} part={part} names={["radius_mm"]} least={5} />
      ) : (
        <Numbers world={world} thing={thing} part={part} names={["width_mm", "height_mm"]} least={5} />
      )}
      <div className="world-fields gap-m">
        <NumberField
          label={t("world.mass")}
          unit="g"
          value={part.mass_g}
          min={1}
          max={HEAVIEST_G}
          testId="world-mass"
          keep={(mass_g, stepped) => keep({ mass_g: tidy(mass_g) }, "mass", stepped)}
        />
        <NumberField
          label={t("world.friction")}
          unit=""
          value={part.friction}
          min={0}
          max={ROUGHEST}
          step={0.01}
          testId="world-friction"
          keep={(friction, stepped) => keep({ friction: tidy(friction) }, "friction", stepped)}
        />
      </div>
    </>
  );
}

/** The zone as a circle or as a rectangle of about the same size. */
function shaped(zone: Part<"zone">, shape: string): Part<"zone"> {
  if (shape === "circle") {
    const radius_mm = zone.radius_mm || Math.max(zone.width_mm, zone.height_mm) / 2 || 100;
    return { ...zone, radius_mm, width_mm: 0, height_mm: 0 };
  }
  const side = 2 * zone.radius_mm;
  return { ...zone, radius_mm: 0, width_mm: zone.width_mm || side, height_mm: zone.height_mm || side };
}

export function ZoneFields({ world, thing, part }: PartProps<Part<"zone">>) {
  const keep = (after: Part<"zone">, what = "", stepped = false) =>
    set(world, thing, withPart(world, thing, after), what, stepped);
  const round = part.radius_mm > 0;
  return (
    <>
      <div className="world-fields gap-m">
        <Choice
          label={t("world.zone-kind")}
          testId="world-zone-kind"
          value={part.kind}
          options={KINDS.map((one) => [one, t(`world.${one}` as Key)])}
          keep={(kind) => keep({ ...part, kind: KINDS.find((one) => one === kind) ?? "warm" })}
        />
        <NumberField
          label={t("world.value")}
          unit={part.kind === "warm" ? "°C" : "%"}
          value={part.value}
          min={0}
          max={100}
          step={1}
          testId="world-value"
          keep={(value, stepped) => keep({ ...part, value: tidy(value) }, "value", stepped)}
        />
        <Choice
          label={t("world.shape")}
          testId="world-shape"
          value={round ? "circle" : "rectangle"}
          options={[
            ["circle", t("world.circle")],
            ["rectangle", t("world.rectangle")],
          ]}
          keep={(shape) => keep(shaped(part, shape))}
        />
      </div>
      <Place world={world} thing={thing} part={part} />
      <Numbers
        world={world}
        thing={thing}
        part={part}
        names={round ? ["radius_mm"] : ["width_mm", "height_mm"]}
        least={LEAST_MM}
      />
      <Numbers world={world} thing={thing} part={part} names={["falloff_mm"]} />
    </>
  );
}
