/** Everything the page's look needs, fonts included; importing this file is enough. */
import "@fontsource-variable/inter/wght.css";
import "@fontsource-variable/jetbrains-mono/wght.css";

import "./tokens.css";
import "./tokens-contrast.css";
import "./forced-colors.css";
import "./base.css";
import "./mirror.css";
