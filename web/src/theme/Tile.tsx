/** The coloured square with an icon that stands for a constructor, method or robot object. */
import { Icon } from "./Icon";

export type Category = "loop" | "choice" | "parallel" | "action" | "test" | "team";

interface TileProps {
  icon: string;
  colour: Category;
  size?: number;
}

export function Tile({ icon, colour, size = 28 }: TileProps) {
  return (
    <span
      className="tile"
      aria-hidden="true"
      style={{
        width: size,
        height: size,
        background: `var(--${colour}-tile)`,
        color: `var(--${colour}-on-tile)`,
      }}
    >
      <Icon name={icon} size={Math.round(size * 0.6)} />
    </span>
  );
}
