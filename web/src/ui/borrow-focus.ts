/**
 * Gives the focus to something, in an effect. What is returned is the effect's cleanup and gives it back, unless something
 * else has taken it by then, such as a question that came up.
 */
export function borrowFocus(to: HTMLElement | null | undefined): () => void {
  const before = document.activeElement;
  to?.focus();
  return () => {
    const lost = document.activeElement === null || document.activeElement === document.body;
    if (lost && before instanceof HTMLElement) before.focus();
  };
}
