/**
 * The secret that the server put into the address when it opened the page.
 *
 * It moves from the address bar to the storage of this address at once, so that it is neither bookmarked nor shown. Another
 * tab finds it there. It serves for one studio only: the next one has another. In a class it is the key of the pupil or of the
 * teacher.
 */
/** For whom a server of a class has sent the page: "pupil", "teacher", or nobody in particular. */
export const pageRole = document.querySelector<HTMLMetaElement>('meta[name="kitrobot-class"]')?.content ?? "";

/** A teacher may be at a pupil's page, too. */
const KEY = `kitrobot.token${pageRole}`;

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
    if (given === null) return localStorage.getItem(KEY) ?? "";
    localStorage.setItem(KEY, given);
  } catch {
    // Without storage the secret stays in the address: a reload needs it there.
    return given ?? "";
  }
  address.searchParams.delete("token");
  window.history.replaceState(window.history.state, "", address);
  return given;
}

/** Whether this is the page of a class for somebody who has not joined yet. */
export const isJoining = (): boolean => pageRole !== "" && token() === "";

/** What tells this pupil from others at this computer; "" outside of a class. */
export const pupilName = (): string => (pageRole === "pupil" ? token().slice(0, 12) : "");

/** The secret of a studio that started anew at this address. */
export function takeToken(given: string): void {
  held = given;
  try {
    localStorage.setItem(KEY, given);
  } catch {
    // Then this page alone has it.
  }
}

/** For tests: forget what was taken. */
export function forgetToken(): void {
  held = null;
}
