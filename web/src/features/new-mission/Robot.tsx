/** A robot in a small picture. */
const LENGTH = 54;

interface RobotProps {
  kind: string;
  x: number;
  y: number;
  /** In radians, against the clock. */
  heading: number;
  /** In units of the picture. */
  length: number;
}

export function Robot({ kind, x, y, heading, length }: RobotProps) {
  const turn = (-heading * 180) / Math.PI;
  return (
    <g
      data-kind={kind}
      transform={`translate(${String(x)} ${String(y)}) rotate(${String(turn)}) scale(${String(length / LENGTH)})`}
    >
      <rect className="picture-robot" x="-27" y="-19" width="54" height="38" rx="9" />
      <path className="picture-front" d="M14 -11V11" />
    </g>
  );
}
