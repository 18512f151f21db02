/** The robots of a robotSet side by side, one of each kind. */
import { Robot } from "../../components/RobotPicture";

/** How wide a robot's place is, and a row of two. */
const [PLACE, ROW] = [80, 2];

export function RobotsPicture({ robots }: { robots: readonly string[] }) {
  const columns = Math.min(ROW, robots.length);
  const rows = Math.ceil(robots.length / ROW);
  const [width, height] = [columns * PLACE, rows * PLACE];
  return (
    <svg className="picture picture-world" viewBox={`0 0 ${String(width)} ${String(height)}`} aria-hidden="true">
      {robots.map((kind, index) => (
        <Robot
          key={kind}
          kind={kind}
          index={index}
          x={(index % ROW) * PLACE + PLACE / 2}
          y={Math.floor(index / ROW) * PLACE + PLACE / 2}
          heading={Math.PI / 2}
          length={PLACE * 0.75}
        />
      ))}
    </svg>
  );
}
