/** The three-address code of the program in view: asked for while it is looked at, and again when the program is another. */
import { useEffect, useState } from "react";

import { api } from "../../api/client";
import { useStudio } from "../../model/studio";

/** The listing of the newest report; "" while there is none, or nobody looks. */
export function useListing(looks: boolean): string {
  const [listing, setListing] = useState("");
  const name = useStudio((studio) => studio.activeProgram);
  const found = useStudio((studio) => studio.report?.programs.find((one) => one.name === studio.activeProgram));
  const empty = (found?.instructions ?? 0) === 0;
  useEffect(() => {
    if (!looks || empty) return;
    let wanted = true;
    const { mission, file } = useStudio.getState();
    api.image(mission, file.path, name).then(
      (made) => {
        if (wanted) setListing(made.listing);
      },
      // The mission is another one by now, or the server is away: the next report, or the banner, says so.
      () => undefined,
    );
    return () => {
      wanted = false;
    };
  }, [looks, empty, found, name]);
  return looks && !empty ? listing : "";
}
