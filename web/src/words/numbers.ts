/** Numbers and times as the page writes them. */
/** Times of a run in words: "00:42.6". */
export function clock(seconds: number): string {
  const tenths = Math.floor(Math.max(seconds, 0) * 10 + 1e-6);
  const minutes = Math.floor(tenths / 600);
  const rest = tenths % 600;
  return `${String(minutes).padStart(2, "0")}:${String(Math.floor(rest / 10)).padStart(2, "0")}.${String(rest % 10)}`;
}

/** A mark on the time axis: "0:50", "12:00". */
export function axisTime(seconds: number): string {
  return `${String(Math.floor(seconds / 60))}:${String(Math.round(seconds % 60)).padStart(2, "0")}`;
}

/** 2130 → "2 130", with a narrow space. */
export function grouped(number: number): string {
  return String(number).replace(/\B(?=(\d{3})+$)/g, "\u2009");
}
