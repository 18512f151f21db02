/** The fields of what lies around its middle: boxes, balls and zones. */
import { type Key, t } from "../../i18n/words";
import { LARGEST_MM, type Part, tidy } from "../../model/world/part-reference";
import { NumberField } from "./NumberField";
import { Choice, Numbers, type PartProps } from "./part-fields";

const [HEAVIEST_G, ROUGHEST] = [1_000_000, 10];
const KINDS = ["warm", "loud", "bright"] as const;
/** What a zone measures less than of a world says nothing of its shape. */
const LEAST_MM = 1;

const PLACE = ["x_mm", "y_mm"] as const;

export function BoxFields(props: PartProps<Part<"box">>) {
  return (
    <>
      <Numbers {...props} names={PLACE} least={-LARGEST_MM} />
      <Numbers {...props} names={["width_mm", "height_mm"]} least={5} />
      <Pushable {...props} />
    </>
  );
}

export function BallFields(props: PartProps<Part<"ball">>) {
  return (
    <>
      <Numbers {...props} names={PLACE} least={-LARGEST_MM} />
      <Numbers {...props} names={["radius_mm"]} least={5} />
      <Pushable {...props} />
    </>
  );
}

/** What is pushed is heavy, and rubs. */
function Pushable<P extends Part<"box"> | Part<"ball">>({ part, keep }: PartProps<P>) {
  return (
    <>
      <div className="world-fields gap-m">
        <NumberField
          label={t("world.mass")}
          unit="g"
          value={part.mass_g}
          min={1}
          max={HEAVIEST_G}
          testId="world-mass"
          keep={(mass_g, stepped) => keep({ ...part, mass_g: tidy(mass_g) }, "mass", stepped)}
        />
        <NumberField
          label={t("world.friction")}
          unit=""
          value={part.friction}
          min={0}
          max={ROUGHEST}
          step={0.01}
          testId="world-friction"
          keep={(friction, stepped) => keep({ ...part, friction: tidy(friction) }, "friction", stepped)}
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

export function ZoneFields(props: PartProps<Part<"zone">>) {
  const { part, keep } = props;
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
      <Numbers {...props} names={PLACE} least={-LARGEST_MM} />
      <Numbers {...props} names={round ? ["radius_mm"] : ["width_mm", "height_mm"]} least={LEAST_MM} />
      <Numbers {...props} names={["falloff_mm"]} />
    </>
  );
}
