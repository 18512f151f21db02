/** A button with which the reader lets the page use a board of this computer; where it cannot, why, and what can. */
import { t } from "../../i18n/words";
import { useBoards } from "./boards";
import { findBoard, reach } from "./serial";
import { Button } from "../../ui/Button";

export function FindBoard() {
  const you = useBoards((state) => state.you);
  if (you === "") return null;
  const now = reach();
  if (now !== "there") {
    return (
      <p className="robots-note muted" data-testid="find-board-not">
        {t(now === "none" ? "boards.find-none" : "boards.find-unsafe")}
      </p>
    );
  }
  return (
    <div className="robots-find row wrap">
      <Button icon="radio" testId="find-board" onClick={() => void findBoard()}>
        {t("boards.find")}
      </Button>
      <span className="robots-note muted">{t("boards.find-help")}</span>
    </div>
  );
}
