/** Files that a person drops or chooses. What takes them in is fetched when there are some. */
import { moreWords, t } from "../../i18n/words";
import { reportError } from "../../session/document";
import type { Feature } from "../../session/features";
import { menuItem } from "../../ui/menu-model";
import type * as taking from "./take";

function take(act: (loaded: typeof taking) => unknown): void {
  Promise.all([import("./take"), moreWords()]).then(([loaded]) => act(loaded), reportError);
}

export const importFiles: Feature = {
  name: "import-files",
  words: { "file-parts": "search.import" },
  useMenu: () => ({
    add: [menuItem("file-parts", t("parts.add-file"), null, () => take(({ chooseParts }) => chooseParts()))],
  }),
  takeFiles: (files) => take(({ takeFiles }) => takeFiles(files)),
};
