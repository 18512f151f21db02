/** Puts the studio on the page. */
import { Fragment, StrictMode } from "react";
import { createRoot } from "react-dom/client";

import { token } from "./api/token";
import { preparePrinting } from "./out/print";
import { Reach } from "./reach/Reach";
import { App } from "./shell/App";
import { installTheme } from "./theme";
import "./theme/styles";
import { installLanguage, useLanguage } from "./words/language";

const found = document.getElementById("root");
if (found === null) throw new Error("index.html has no #root");
const root = found;

/** Words are read while drawing: another language draws the page anew, from the same document. */
function Spoken() {
  const language = useLanguage((state) => state.language);
  return (
    <Fragment key={language}>
      <App />
      <Reach />
    </Fragment>
  );
}

token();
installTheme();
preparePrinting();
void installLanguage().then(() => {
  createRoot(root).render(
    <StrictMode>
      <Spoken />
    </StrictMode>,
  );
});
