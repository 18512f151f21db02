/** Puts the studio on the page. */
import "./theme/shared.css";
import "./theme/styles";

import { StrictMode } from "react";
import { createRoot } from "react-dom/client";

import { isJoining, token } from "./api/token";
import { inPage } from "./api/transport";
import { App, Journal } from "./app/App";
import { installLanguage, useLanguage } from "./i18n/language";
import { installTheme } from "./theme";
import { guardRemoving } from "./ui/second-click";

// First of all styles: each part's own rules are stronger.

const found = document.getElementById("root");
if (found === null) throw new Error("index.html has no #root");
const root = found;

/** Words are read while drawing: another language draws the page anew, from the same document, beside the same journal. */
function Spoken() {
  const language = useLanguage((state) => state.language);
  return (
    <>
      <Journal />
      <App key={language} />
    </>
  );
}

token();
installTheme();
guardRemoving();
const spoken = installLanguage();
// A static site has Python in a worker of the page, and says so.
const site = inPage() && !isJoining() ? import("./site/open").then(({ openSite }) => openSite(spoken)) : null;
void Promise.all([spoken, site]).then(() => {
  createRoot(root).render(
    <StrictMode>
      <Spoken />
    </StrictMode>,
  );
});
