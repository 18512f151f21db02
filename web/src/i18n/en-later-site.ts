/** English for a static site, where Python runs in the page itself. */
export const SITE_EN = {
  "site.fetching": "KitRobot is coming: {percent} %",
  "site.starting": "KitRobot is starting …",
  "site.other-tab": "KitRobot is open in another tab of this browser.",
  "site.other-tab-help": "Close that tab, and this one goes on by itself.",
  "site.unfetched": "A part of KitRobot could not be fetched.",
  "site.unfetched-help": "Look whether you are online, then load the page again.",
  "site.broken": "KitRobot cannot start in this browser.",
  "site.broken-help":
    "Load the page again. If that does not help, use a newer version of Chrome, Edge, Firefox or Safari.",
  "site.full": "This browser has no room left for your work.",
  "site.full-help":
    "Nothing is lost while this page stays open: choose Download .krt in the menu File before you close it.",
  "site.denied": "This browser keeps nothing of this page; perhaps it is a private window.",
  "site.denied-help": "Choose Download .krt in the menu File before you close the page.",
  "site.unread": "The work that this browser keeps cannot be read now.",
  "site.unread-help":
    "It is still there, and nothing is written over it. Load the page again; what you make until then is not kept: choose Download .krt in the menu File.",
  "site.newer": "There is a new version of KitRobot.",
  "site.renew": "Load it",
  "site.renewing": "The new version is coming.",
  "site.renewing-help": "The page loads by itself as soon as the browser lets it; your work is kept.",
  "site.crowd": "So many robots are slow in a page.",
  "site.crowd-help": "KitRobot installed on a computer runs them at full speed.",
  "site.again": "Load again",
  "site.copy-link": "Copy a link with this mission in it",
  "site.link-copied": "The link is copied: paste it where you want it.",
  "site.link-shown": "The link stands in the address bar: copy it from there.",
  "site.link-copied-help": "The mission is in the link itself, as it is now; robots and worlds of your own are not.",
  "site.link-long": "This mission is too large for a link.",
  "site.link-damaged": "The mission in this link is damaged.",
  "site.link-help": "Use the file instead: choose Download .krt in the menu File, and drop the file on the page.",
} as const;
