/**
 * The secret that the server put into the address when it opened the page.
 *
 * It moves from the address bar to this tab's session storage at once, so that it is neither bookmarked nor shown.
 */
const KEY = "kitrobot.token";

let held: string | null = null;

/** The secret, "" when the page was opened without one. */
export function token(): string {
  held ??= take();
  return held;
}

function take(): string {
  const address = new URL(window.location.href);
  const given = address.searchParams.get("token");
  try {
    if (given === null) return sessionStorage.getItem(KEY) ?? "";
    sessionStorage.setItem(KEY, given);
  } catch {
    // Without storage the secret stays in the address: a reload needs it there.
    return given ?? "";
  }
  address.searchParams.delete("token");
  window.history.replaceState(window.history.state, "", address);
  return given;
}

/** For tests: forget what was taken. */
export function forgetToken(): void {
  held = null;
}
