/** Coming in: the code of the class and a name; a name that is there needs the word, or the teacher's yes. */
import "./class.css";

import { type FormEvent, type ReactNode, useEffect, useRef, useState } from "react";

import { classApi } from "../../api/class";
import { ApiError } from "../../api/client";
import { type Failure, whyRefused } from "../../api/refusal";
import { siteParts } from "../../api/site-parts";
import { takeToken } from "../../api/token";
import { inPage } from "../../api/transport";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { readExerciseLink } from "../../session/exercise-link";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { forgetLeft } from "./left";

const ASK_MS = 2000;

function comeIn(key: string): void {
  takeToken(key);
  // The studio begins with nothing of who was here before.
  window.location.reload();
}

function Field({ label, help, children }: { label: string; help?: string; children: ReactNode }) {
  return (
    <label className="join-field">
      <span>{label}</span>
      {children}
      {help === undefined ? null : <small>{help}</small>}
    </label>
  );
}

export function Join() {
  const [about, setAbout] = useState<{ name: string; joining: boolean } | null>(null);
  const [link] = useState(() => readExerciseLink(window.location.hash));
  const [typed, setCode] = useState<string | null>(null);
  const [name, setName] = useState("");
  const [word, setWord] = useState("");
  /** The name that is taken. */
  const [taken, setTaken] = useState("");
  const [asked, setAsked] = useState("");
  const [failure, setFailure] = useState<Failure | null>(null);
  const [busy, setBusy] = useState(false);
  const nameField = useRef<HTMLInputElement>(null);

  const other = about !== null && (link?.className ?? "") !== "" && link?.className !== about.name;
  // The code of another class lets nobody in here.
  const code = typed ?? (other ? "" : (link?.code ?? ""));

  const codeField = useRef<HTMLInputElement>(null);
  useEffect(() => {
    if (other) codeField.current?.focus();
  }, [other]);

  const fail = (cause: unknown) => setFailure(whyRefused(cause));
  useEffect(forgetLeft, []);
  useEffect(fetchAhead, []);
  useEffect(() => {
    const look = () => {
      classApi.about().then((found) => {
        setAbout(found);
        setFailure((before) => (before?.message === t("class.offline") ? null : before));
      }, fail);
    };
    look();
    const timer = setInterval(look, 5 * ASK_MS);
    return () => clearInterval(timer);
  }, []);
  useEffect(() => {
    if (asked === "") return;
    const timer = setInterval(() => {
      classApi.asked(asked).then(
        (said) => {
          if (said.state === "waiting") return;
          setAsked("");
          if (said.state === "in" && said.key) comeIn(said.key);
          else setFailure({ message: t("class.said-no"), help: "" });
        },
        (cause: unknown) => {
          if (!(cause instanceof ApiError) || cause.status !== 0) setAsked("");
          fail(cause);
        },
      );
    }, ASK_MS);
    return () => clearInterval(timer);
  }, [asked]);

  const join = (event: FormEvent) => {
    event.preventDefault();
    setBusy(true);
    setFailure(null);
    classApi
      .join(code, name, taken === "" ? "" : word)
      .then((said) => {
        if (said.state === "in" && said.key) comeIn(said.key);
        else setTaken(name.trim());
      }, fail)
      .finally(() => setBusy(false));
  };
  const askTeacher = () => {
    setFailure(null);
    classApi.ask(code, name).then((said) => setAsked(said.asked), fail);
  };
  const again = () => {
    setTaken("");
    setWord("");
    setAsked("");
    nameField.current?.focus();
  };

  return (
    <main className="join centred scroll" aria-label={t("class.join-title", { name: about?.name ?? "" })}>
      <form className="join-card surface" onSubmit={join} data-testid="join">
        <h1>{t("class.join-title", { name: `\u2068${about?.name ?? "…"}\u2069` })}</h1>
        {other ? (
          <p className="join-other notice" role="status" data-testid="join-other">
            {t("class.other-link", { wanted: link?.className ?? "", name: about.name })} {t("class.other-link-help")}
          </p>
        ) : null}
        {about?.joining === false ? <p>{t("class.no-joining")}</p> : null}
        <Field label={t("class.code")} help={t("class.code-help")}>
          <input
            className="field join-code"
            data-testid="join-code"
            ref={codeField}
            value={code}
            onChange={(event) => setCode(event.target.value.toUpperCase())}
            autoCapitalize="characters"
            autoComplete="off"
            spellCheck={false}
            maxLength={12}
            dir="ltr"
            required
            autoFocus={code === ""}
          />
        </Field>
        <Field label={t("class.your-name")}>
          <input
            className="field"
            data-testid="join-name"
            ref={nameField}
            value={name}
            onChange={(event) => {
              setName(event.target.value);
              setTaken("");
            }}
            autoComplete="off"
            spellCheck={false}
            maxLength={60}
            dir="auto"
            required
            autoFocus={code !== ""}
          />
        </Field>
        {taken === "" ? null : (
          <div className="join-taken" data-testid="join-taken">
            <p role="status">
              <strong>{t("class.taken", { name: taken })}</strong> {t("class.taken-help", { name: taken })}
            </p>
            <Field label={t("class.word")}>
              <input
                className="field join-code"
                data-testid="join-word"
                value={word}
                onChange={(event) => setWord(event.target.value.toUpperCase())}
                autoComplete="off"
                spellCheck={false}
                maxLength={12}
                dir="ltr"
                autoFocus
              />
            </Field>
          </div>
        )}
        <p className="join-failure notice" role="alert" data-testid="join-failure">
          {failure === null ? null : (
            <>
              <Said text={failure.message} /> <Said text={failure.help} />
            </>
          )}
        </p>
        {asked === "" ? null : (
          <p role="status" className="join-asking row">
            <Icon name="hourglass" size={18} /> {t("class.asking")}
          </p>
        )}
        <div className="join-foot wrap flex gap-m">
          <Button ink type="submit" disabled={busy} testId="join-go">
            {t(taken === "" ? "class.join" : "class.come-back")}
          </Button>
          {taken === "" ? null : (
            <>
              <Button onClick={askTeacher} disabled={asked !== ""} testId="join-ask">
                {t("class.ask-teacher")}
              </Button>
              <Button onClick={again}>{t("class.other-name")}</Button>
            </>
          )}
        </div>
      </form>
    </main>
  );
}

/** The files of Python are fetched while a pupil types code and name: the browser has them when the studio asks for them. */
function fetchAhead(): void {
  if (inPage()) void fetchFiles().catch(() => undefined);
}

async function fetchFiles(): Promise<void> {
  const { files } = await siteParts();
  await Promise.all(Object.keys(files).map(async (name) => (await fetch(name)).arrayBuffer()));
}
