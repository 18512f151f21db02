/** Says across the page that what moves is a recording, and leads to a live run of the same mission and back. */
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { shownName } from "../../session/document";
import { type OpenRecording, playAgain, runRecorded } from "../../session/recordings";
import { isLive, useRun } from "../../session/run";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";

export function RecordingBar({ open }: { open: OpenRecording }) {
  const playing = useRun((run) => run.recording);
  const live = useRun((run) => isLive(run.status));
  const stops = useStudio(({ mission }) => mission.breakpoints?.some((one) => one.enabled !== false) === true);
  const name = shownName(open.path);
  const what = playing ? (open.real ? "recording.real" : "recording.playing") : "recording.live";
  return (
    <div
      className="banner banner-note row rigid gap-xl"
      role="status"
      data-testid="recording-bar"
      data-playing={playing}
    >
      <Icon name="clapperboard" size={18} />
      <p>
        <strong>
          <Said text={t(what, { name, seed: open.seed })} />
        </strong>{" "}
        {playing ? <Said text={t(open.cut ? "recording.cut" : "recording.nothing")} /> : null}{" "}
        {playing && stops ? t("recording.breakpoints") : null}
      </p>
      {playing && live ? null : (
        <Button testId="play-recording" onClick={playAgain}>
          {t(playing ? "recording.again" : "recording.play")}
        </Button>
      )}
      {playing ? (
        <Button icon="play" testId="run-recorded" onClick={runRecorded}>
          {t("recording.run")}
        </Button>
      ) : null}
    </div>
  );
}
