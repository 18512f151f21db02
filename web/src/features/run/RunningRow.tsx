/** A token for each live thread, and a choice of the agent that is watched; fetched when something runs first. */
import { useRef } from "react";

import { t } from "../../i18n/words";
import { useRun } from "../../session/run";
import { useFolding } from "../../ui/folding";
import { menuItem } from "../../ui/menu-model";
import { MenuButton } from "../../ui/MenuButton";
import { Select } from "../../ui/Select";

export interface Thread {
  slot: number;
  label: string;
  go: () => void;
}

function Sign() {
  return (
    <svg width="7" height="8" viewBox="0 0 7 8" aria-hidden="true">
      <path d="M0 0l7 4-7 4z" fill="currentColor" />
    </svg>
  );
}

/** All threads behind one token. */
function ThreadList({ threads }: { threads: Thread[] }) {
  return (
    <span data-folded="2">
      <MenuButton
        id="threads"
        label={t("tabs.threads")}
        aria-label={t("tabs.threads-count", { count: threads.length })}
        className="token"
        entries={threads.map(({ slot, label, go }) => menuItem(`thread-${String(slot)}`, label, null, go))}
      >
        <Sign />×{threads.length}
      </MenuButton>
    </span>
  );
}

export function RunningRow({ threads, names, chosen }: { threads: Thread[]; names: string[]; chosen: string }) {
  const row = useRef<HTMLDivElement>(null);
  useFolding(row);
  return (
    <div className="tabs-end" ref={row}>
      {threads.length === 0 ? null : (
        <>
          <span className="tabs-running muted small-text" data-fold={1}>
            {t("tabs.running")}
          </span>
          {threads.map(({ slot, label, go }) => (
            <button
              type="button"
              key={slot}
              className="token"
              data-testid={`thread-${String(slot)}`}
              data-fold={2}
              aria-label={label}
              onClick={go}
            >
              <Sign />
              {slot}
            </button>
          ))}
          <ThreadList threads={threads} />
        </>
      )}
      {names.length < 2 ? null : (
        <Select
          className="watched small-text typed"
          label={t("tabs.watch")}
          testId="watched-agent"
          title={chosen}
          value={chosen}
          options={names}
          keep={(name) => useRun.getState().selectAgent(name)}
        />
      )}
    </div>
  );
}
