/** The state of an agent as a shape, so that it never rests on a hue: ● running ◐ waiting ○ idle ✕ failed ‖ stalled. */
import type { AgentActivity } from "../api/wire";

export function StateShape({ state, size = 8, label }: { state: AgentActivity; size?: number; label?: string }) {
  const spoken = label === undefined ? { "aria-hidden": true } : { role: "img", "aria-label": label };
  return (
    <svg className="rigid" width={size} height={size} viewBox="0 0 10 10" data-state={state} {...spoken}>
      {state === "failed" ? (
        <path d="M1.5 1.5l7 7M8.5 1.5l-7 7" stroke="currentColor" strokeWidth="2.2" strokeLinecap="round" />
      ) : state === "stalled" ? (
        <path d="M3 1.5v7M7 1.5v7" stroke="currentColor" strokeWidth="2.2" strokeLinecap="round" />
      ) : (
        <>
          <circle
            cx="5"
            cy="5"
            r="4"
            fill={state === "running" ? "currentColor" : "none"}
            stroke="currentColor"
            strokeWidth="1.6"
          />
          {state === "waiting" ? <path d="M5 1a4 4 0 0 0 0 8z" fill="currentColor" /> : null}
        </>
      )}
    </svg>
  );
}
