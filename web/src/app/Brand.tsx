/** The sign of the studio: a way from one point to another. */
export function Brand() {
  return (
    <svg className="brand rigid" width="16" height="16" viewBox="0 0 16 16" aria-hidden="true">
      <path d="M3 12.5C3 7 7 3.5 12.5 3.5" fill="none" stroke="currentColor" strokeWidth="2" strokeLinecap="round" />
      <circle cx="3" cy="13" r="2" fill="currentColor" />
      <circle cx="13" cy="3.5" r="2" fill="currentColor" />
    </svg>
  );
}
