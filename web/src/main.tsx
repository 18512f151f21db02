/** Puts the studio on the page. */
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";

import { token } from "./api/token";
import { App } from "./shell/App";
import { installTheme } from "./theme";
import "./theme/styles";
import { chooseLanguage } from "./words/words";

const root = document.getElementById("root");
if (root === null) throw new Error("index.html has no #root");

token();
installTheme();
document.documentElement.lang = chooseLanguage(navigator.languages);

createRoot(root).render(
  <StrictMode>
    <App />
  </StrictMode>,
);
