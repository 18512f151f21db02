/** One state of the model in its world: robots have dashed rings, since only the model has seen it. */
import type { Scene } from "../../api/generated";
import { WorldPicture } from "../../components/WorldPicture";
import { shortName } from "../../model/short-name";
import type { Mission, World } from "../../model/types";

/** The radius of a ring, as a part of the world's width. */
const RING = 0.045;

export function SceneArena({ scene, mission, world }: { scene: Scene; mission: Mission; world: World }) {
  const { width_mm: width, height_mm: height } = world;
  const ring = Math.max(width, height) * RING;
  return (
    <div className="check-arena relative" style={{ aspectRatio: `${String(width)} / ${String(height)}` }}>
      <WorldPicture world={world} agents={[]} />
      <svg viewBox={`0 0 ${String(width)} ${String(height)}`} aria-hidden="true">
        {scene.robots.map(({ x_mm: x, y_mm: y, heading_rad: turn }, robot) => (
          <g
            key={robot}
            className="check-robot"
            style={{ transform: `translate(${String(x)}px, ${String(height - y)}px)` }}
          >
            <circle r={ring} />
            <path
              d={`M${String(ring)} ${String(-ring / 3)}L${String(ring * 1.4)} 0L${String(ring)} ${String(ring / 3)}Z`}
              transform={`rotate(${String((-turn * 180) / Math.PI)})`}
            />
            <text fontSize={ring} textAnchor="middle" dominantBaseline="central">
              {shortName(mission.agents[robot]?.name ?? "").slice(0, 2)}
            </text>
          </g>
        ))}
      </svg>
    </div>
  );
}
