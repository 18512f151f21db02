/**
 * The pupil's side of a class: tells it what happens here, hands the work in (`hand-in-queue`), and hears what the teacher
 * wants. It asks nothing of the studio's own Python but to read files and to list exercises.
 */
import { classApi, type ClassSocket, openClassSocket } from "../../api/class";
import { api, ApiError } from "../../api/client";
import type { HandMessage, PupilNewsMessage, ReportMessage, ShowArenaMessage, TurnMessage } from "../../api/generated";
import { takeToken } from "../../api/token";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { asMissionPath, reportError, shownName, whenReady } from "../../session/document";
import { readExerciseLink } from "../../session/exercise-link";
import {
  remember as rememberExercise,
  setComments,
  setHandIn,
  useOpenExercise,
  workedOn,
} from "../../session/open-exercise";
import { beginMission } from "../../session/open-requests";
import { useRun } from "../../session/run";
import { endAll, listen } from "../../ui/effects";
import { watchHash } from "../../ui/page-hash";
import { tellArena } from "./arena";
import { loseConnection, setConnected, setConnection, setHand, setNews, useClassroom } from "./classroom";
import { placeFor, storageName, StoredMemory } from "./hand-in-memory";
import { HandInQueue } from "./hand-in-queue";
import { forgetKept, leaveFiles } from "./left";
import { openLinked } from "./linked";
import { exerciseOffer, offer, openHanded, openOrOffer } from "./pupil-offers";
import { reportOf } from "./pupil-report";

const REPORT_MS = 700;

type Said = ReportMessage | HandMessage | TurnMessage | ShowArenaMessage;

/** Whether the class still knows this pupil; else the page is the one for joining again. */
async function expectIn(): Promise<void> {
  try {
    await classApi.works();
  } catch (cause) {
    if (cause instanceof ApiError && cause.status === 403) leaveClass();
  }
}

/** Out of the class, in this browser; the work is with the class. */
function leaveClass(): void {
  takeToken("");
  window.location.reload();
}

/** A pupil's page in a class, from its beginning to its end. */
class PupilSync {
  readonly #memory = new StoredMemory();
  readonly #queue = new HandInQueue(this.#memory, {
    emptied: () => {
      if (this.#letting) this.#giveTurn(true);
    },
    forbidden: () => void expectIn(),
  });
  #socket: ClassSocket<Said> | null = null;
  /** The teacher is let in to edit once everything is handed in. */
  #letting = false;
  /** The name under which work of the class is opened next: it goes on where it was. */
  #goesOn = "";
  readonly #counts = { edits: 0, runs: 0 };
  /** One after the other: each goes on from what the one before remembered. */
  #hearing: Promise<void> = Promise.resolve();
  #told = "";
  #reporting: ReturnType<typeof setTimeout> | undefined;

  readonly #openWork = async (name: string, exercise: string): Promise<void> => {
    const { bytes, revision } = await classApi.work(name);
    this.#memory.keep({ places: { ...this.#memory.value.places, [name]: { name, revision } } });
    this.#goesOn = name;
    if (exercise !== "") rememberExercise({ name: exercise, path: asMissionPath(name) });
    beginMission(() => api.readMission(name, bytes), name);
  };

  /** Follows the link of the address; `className` is "" while the class does not answer. */
  #follow(className: string): void {
    if (readExerciseLink(window.location.hash) === null) return;
    // Nothing else comes over what is opened now.
    if (!this.#memory.value.begun && className === "") this.#memory.keep({ begun: true });
    const waits = (exercise: string) => this.#queue.hasWorkOn(exercise);
    this.#hearing = this.#hearing
      .then(whenReady)
      .then(() => openLinked({ className, waits, openWork: this.#openWork }))
      .catch(reportError);
  }

  /** The first page of this pupil in this browser: goes on where the pupil was, else begins what the class does. */
  async #beginFirst(news: PupilNewsMessage): Promise<void> {
    this.#memory.keep({ begun: true, handed: news.handed, exercise: news.exercise });
    // A link says itself what is opened.
    if (readExerciseLink(window.location.hash) !== null) return;
    const [newest] = await classApi.works();
    if (newest !== undefined) await this.#openWork(newest.name, newest.exercise ?? "");
    else if (news.handed > 0) openHanded(news.handed_name);
    else if (news.exercise !== "") (await exerciseOffer(news.exercise))?.open?.();
  }

  #hear(news: PupilNewsMessage): void {
    const before = useClassroom.getState().news?.turn;
    setNews(news);
    this.#hearing = this.#hearing
      .then(whenReady)
      .then(() => this.#obey(news))
      .then(() => (before === "teacher" && news.turn === "pupil" ? this.#takeBack() : undefined))
      .catch(reportError);
    this.#follow(news.class_name);
  }

  async #obey(news: PupilNewsMessage): Promise<void> {
    setComments(news.comments);
    this.#offerComment(news.comments);
    if (!this.#memory.value.begun) {
      await this.#beginFirst(news);
      return;
    }
    if (news.handed > this.#memory.value.handed) {
      this.#memory.keep({ handed: news.handed });
      openOrOffer({ kind: "handed", words: news.handed_name, open: () => openHanded(news.handed_name) });
    }
    if (news.exercise !== this.#memory.value.exercise) {
      this.#memory.keep({ exercise: news.exercise });
      const one = news.exercise === "" ? null : await exerciseOffer(news.exercise);
      if (one !== null) openOrOffer(one);
    }
    if (news.note > this.#memory.value.note) {
      this.#memory.keep({ note: news.note });
      if (news.note_text !== "") offer({ kind: "note", words: news.note_text, open: null });
    } else if (news.note < this.#memory.value.note) this.#memory.keep({ note: news.note });
  }

  /** A new comment is offered where the exercise that it is on, which shows it, is not open. */
  #offerComment(comments: Readonly<Record<string, string>>): void {
    const known = this.#memory.value.comments;
    const fresh = Object.entries(comments).find(([exercise, words]) => known[exercise] !== words);
    if (fresh === undefined && Object.keys(known).length === Object.keys(comments).length) return;
    this.#memory.keep({ comments: { ...comments } });
    if (fresh === undefined) return;
    if (workedOn(useStudio.getState().file) !== fresh[0]) offer({ kind: "comment", words: fresh[1], open: null });
  }

  /** Lets the teacher edit, once the class has what is open here; or not, or not any more. */
  letEdit(yes: boolean): void {
    if (!yes) {
      this.#giveTurn(false);
      return;
    }
    this.#letting = true;
    this.#queue.addAtOnce(false);
  }

  #giveTurn(yes: boolean): void {
    this.#letting = false;
    this.#socket?.say({ type: "turn", yes });
  }

  /** What the teacher saved, as one step that can be taken back. Where something was changed here meanwhile that stays. */
  async #takeBack(): Promise<void> {
    if (!this.#queue.isEmpty) return;
    const mine = this.#queue.place;
    const { bytes, revision } = await classApi.work(mine.name);
    if (revision === mine.revision) return;
    const { mission } = await api.readMission(mine.name, bytes);
    if (!this.#queue.isEmpty || this.#queue.place !== mine) return;
    this.#queue.place = { name: mine.name, revision };
    useStudio.getState().execute({ label: t("class.edited"), execute: () => mission });
  }

  /** Without a connection it goes when the class is back. */
  putHand(up: boolean): void {
    setHand(up);
    this.#socket?.say({ type: "hand", up });
  }

  #report(): void {
    this.#reporting ??= setTimeout(() => {
      this.#reporting = undefined;
      const said = reportOf(this.#counts);
      const words = JSON.stringify(said);
      if (words === this.#told) return;
      this.#told = words;
      this.#socket?.say(said);
    }, REPORT_MS);
  }

  /** The pupil goes. What the class does not have yet stays in this browser. */
  goAway(): void {
    if (this.#queue.isEmpty) {
      leaveFiles();
      forgetKept(storageName());
    }
    leaveClass();
  }

  /** Begins; the returned function ends it. */
  start(): () => void {
    this.#memory.recall();
    this.#socket = openClassSocket<Said, PupilNewsMessage>("pupil", {
      onOpen: () => {
        this.#told = "";
        setConnected(true);
        this.#report();
        const { hand } = useClassroom.getState();
        if (hand !== null) this.putHand(hand);
        this.#queue.goOn();
      },
      onMessage: (news) => this.#hear(news),
      onSilence: (silent) => setConnected(!silent),
      onLost: () => {
        loseConnection();
        void expectIn();
        if (useClassroom.getState().news === null) this.#follow("");
      },
    });
    const offStudio = useStudio.subscribe((state, before) => {
      if (state.change !== before.change && state.change.kind === "open") {
        const shown = shownName(state.file.name);
        const elsewhere = state.file.path === "" || state.file.path.startsWith("example:");
        const fresh = this.#goesOn !== shown && elsewhere && !state.dirty;
        this.#goesOn = "";
        this.#queue.place = placeFor(this.#memory.value, shown, fresh);
        if (state.dirty) this.#queue.add();
      } else if (state.mission !== before.mission) {
        this.#counts.edits++;
        this.#queue.add();
      } else if (state.file.name !== before.file.name) {
        this.#queue.place = placeFor(this.#memory.value, shownName(state.file.name), false);
        this.#queue.add();
      }
      this.#report();
    });
    const offRun = useRun.subscribe(({ status, name }, before) => {
      if (status === before.status) return;
      if (status === "running" && name !== before.name) this.#counts.runs++;
      this.#report();
    });
    const offGoals = useOpenExercise.subscribe(() => this.#report());
    const offArena = tellArena(
      () => useClassroom.getState().news?.looked === true,
      (arena) => this.#socket?.say({ type: "arena", arena }),
    );
    const offHiding = listen(document, { visibilitychange: () => void this.#queue.send() });
    const offHash = watchHash(() => {
      const { news } = useClassroom.getState();
      if (news !== null) this.#follow(news.class_name);
    });
    setHandIn(() => this.#queue.addAtOnce(true));
    return () => {
      endAll(offStudio, offRun, offGoals, offArena, offHiding, offHash, () => setHandIn(null))();
      this.#queue.end();
      clearTimeout(this.#reporting);
      this.#reporting = undefined;
      this.#socket?.close();
      this.#socket = null;
    };
  }
}

export function letEdit(yes: boolean): void {
  useClassroom.getState().connection?.letEdit(yes);
}

export function putHand(up: boolean): void {
  useClassroom.getState().connection?.putHand(up);
}

export function goAway(): void {
  useClassroom.getState().connection?.goAway();
}

/** Begins, or goes on in another language; the returned function ends it. */
export function keepClass(): () => void {
  const connection = useClassroom.getState().connection ?? new PupilSync();
  setConnection(connection);
  return connection.start();
}
