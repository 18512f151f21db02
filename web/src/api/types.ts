/** The server's types, under the names that the page uses. */
export type * from "../model/types";
