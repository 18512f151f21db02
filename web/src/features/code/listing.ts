/** The three-address code of the program in view: asked for while it is looked at, and again when the program is another. */
import { useEffect, useState } from "react";

import { api } from "../../api/client";
import { useStudio } from "../../model/studio";

/** The listing of the newest report; "" while there is none, or nobody looks. */
export function useListing(looks: boolean): string {
  const [made, setMade] = useState({ name: "", listing: "" });
  const name = useStudio((studio) => studio.activeProgram);
  const found = useStudio((studio) => studio.report?.programs.find((one) => one.name === studio.activeProgram));
  const empty = (found?.instructions ?? 0) === 0;
  useEffect(() => {
    if (!looks || empty) return;
    let wanted = true;
    const { mission, file } = useStudio.getState();
    api.image(mission, file.path, name).then(
      ({ listing }) => {
        if (wanted) setMade({ name, listing });
      },
      // The mission is another one by now, or the server is away: the next report, or the banner, says so.
      () => undefined,
    );
    return () => {
      wanted = false;
    };
  }, [looks, empty, found, name]);
  // Never that of another program, which was in view before.
  return looks && !empty && made.name === name ? made.listing : "";
}
