/**
 * The program in view as text: LLL beside the graph, and the three-address code it becomes.
 *
 * The LLL can be written: the graph follows. Selecting on either side shows the other; lines where threads of the watched
 * agent stand are marked.
 */
import "./code.css";

import { useEffect, useState } from "react";

import { api } from "../../api/client";
import { CopyButton } from "../../components/CopyButton";
import { listingExtensions } from "../../components/text/extensions";
import { TextView } from "../../components/text/TextView";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { TEAM_ROBOT } from "../../model/team-robot";
import { type CodeSide, showCode, useCodeSide } from "../../session/code-side";
import { reportError } from "../../session/document";
import { useShown } from "../../session/simple-view";
import { useTyping } from "../../session/typing";
import { awaitAnswer } from "../../ui/effects";
import { later } from "../../ui/later";
import { TabList } from "../../ui/TabList";
import { Lll } from "./Lll";

const Projection = later(() => import("./Projection").then((chunk) => chunk.default), reportError);
export function Code() {
  const wanted = useCodeSide((code) => code.side);
  const isTeam = useStudio((studio) => studio.mission.programs.some((one) => one.robot === TEAM_ROBOT));
  const listed = useShown("listing");
  const sides: CodeSide[] = [
    "lll",
    ...(listed ? (["listing"] as const) : []),
    ...(isTeam ? (["projection"] as const) : []),
  ];
  const side = sides.includes(wanted) ? wanted : "lll";
  const program = useStudio((studio) => studio.activeProgram);
  const found = useStudio((studio) => studio.report?.programs.find((one) => one.name === studio.activeProgram));
  const lll = found?.lll ?? "";
  const listing = useListing(side === "listing");
  const typed = useTyping((typing) => typing.drafts[program]?.text);
  const loaded = found !== undefined;
  return (
    <div className="code column panel" data-testid="code">
      <header className="side-tabs rigid between aligned">
        <TabList
          label={t("view.code")}
          id="code-tab"
          names={sides}
          open={side}
          show={showCode}
          controls="code-panel"
          className="side-tablist flex slim gap-2xl"
          tabClass="side-tab ellipsis muted focus-inside"
          title={(one) => t(`code.${one}`)}
        >
          {(one) => t(`code.${one}`)}
        </TabList>
        {side === "projection" ? null : (
          <CopyButton
            text={side === "lll" ? (typed ?? lll) : listing}
            label={t("code.copy")}
            copied={t("code.copied")}
            testId="copy-code"
          />
        )}
      </header>
      <div className="code-panel fill" id="code-panel" role="tabpanel" aria-labelledby={`code-tab-${side}`}>
        {side === "projection" ? (
          <Projection />
        ) : !loaded ? null : side === "lll" ? (
          <Lll printed={lll.trimEnd()} spans={found.spans} program={program} key={program} />
        ) : (
          <TextView
            text={listing === "" ? t("code.no-listing") : listing.trimEnd()}
            label={t("code.listing-label", { name: program })}
            extensions={listingExtensions}
          />
        )}
      </div>
    </div>
  );
}

/** The listing of the newest report; "" while there is none, or nobody looks. */
export function useListing(looks: boolean): string {
  const [made, setMade] = useState({ name: "", listing: "" });
  const name = useStudio((studio) => studio.activeProgram);
  const found = useStudio((studio) => studio.report?.programs.find((one) => one.name === studio.activeProgram));
  const empty = (found?.instructions ?? 0) === 0;
  useEffect(() => {
    if (!looks || empty) return;
    const { mission, file } = useStudio.getState();
    // Where it fails the mission is another one by now, or the server is away: the next report, or the banner, says so.
    return awaitAnswer(api.image(mission, file.path, name), ({ listing }) => setMade({ name, listing }));
  }, [looks, empty, found, name]);
  // Never that of another program, which was in view before.
  return looks && !empty && made.name === name ? made.listing : "";
}
