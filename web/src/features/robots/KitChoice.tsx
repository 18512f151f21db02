/** What a robot is built of: chosen once, and remembered for it and for the next one. */
import { useEffect } from "react";
import { create } from "zustand";

import type { KitEntry } from "../../api/generated";
import { partsApi } from "../../api/parts";
import { languageInUse, t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { chooseKit } from "./actions";
import { kitFor, useBoards } from "./boards";
import { FirmwareNeed } from "./Firmware";

const useKits = create<{ path: string | null; kits: readonly KitEntry[] }>(() => ({ path: null, kits: [] }));

/** Asks for the kits beside a mission, once for each. */
function useKitsAt(path: string): readonly KitEntry[] {
  const { kits } = useKits();
  useEffect(() => {
    if (useKits.getState().path === path) return;
    useKits.setState({ path });
    partsApi.kits(path).then(
      (found) => {
        if (useKits.getState().path === path) useKits.setState({ kits: found });
      },
      // The robot is then taken as its own file says; the next time that the panel opens it is asked again.
      () => useKits.setState({ path: null }),
    );
  }, [path]);
  return kits;
}

interface KitProps {
  address: string;
  disabled: boolean;
  /** The version of MicroPython that the board has, "" where that is not known. */
  has: string;
  /** The page with MicroPython for the board, "" where none is known. */
  page: string;
}

export function KitChoice({ address, disabled, has, page }: KitProps) {
  const kits = useKitsAt(useStudio((studio) => studio.file.path));
  const state = useBoards();
  const chosen = kitFor(state, address);
  const language = languageInUse();
  const known = kits.some(({ name }) => name === chosen);
  const kit = kits.find(({ name }) => name === chosen);
  const help = kit?.help;
  return (
    <>
      <label className="robot-program">
        <span>{t("boards.kit")}</span>
        <select
          data-testid="robot-kit"
          disabled={disabled}
          title={help?.[language] ?? help?.[""]}
          value={chosen}
          onChange={(event) => chooseKit(address, event.target.value)}
        >
          <option value="">{t("boards.kit-own")}</option>
          {known || chosen === "" ? null : <option>{chosen}</option>}
          {kits.map(({ name, label }) => (
            <option key={name} value={name}>
              {label[language] ?? label[""] ?? name}
            </option>
          ))}
        </select>
      </label>
      {kit === undefined ? null : <FirmwareNeed kit={kit} has={has} page={page} />}
    </>
  );
}
