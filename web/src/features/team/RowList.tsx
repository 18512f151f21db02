/** Rows that can be added and removed: a goal, a failure. The focus goes to what was added, or back to the button. */
import { type ComponentType, type ReactNode, useRef } from "react";

import { Button } from "../../ui/Button";
import { Tool } from "../../ui/Tool";

export interface RowProps<Item> {
  item: Item;
  at: number;
  /** To be called when the row has removed itself. */
  removed: () => void;
}

interface RowListProps<Item> {
  items: readonly Item[];
  Row: ComponentType<RowProps<Item>>;
  heads?: ReactNode;
  add: { testId: string; label: string; can: boolean; run: () => void } | null;
}

export function RowList<Item>({ items, Row, heads, add }: RowListProps<Item>) {
  const button = useRef<HTMLButtonElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const removed = () => void requestAnimationFrame(() => button.current?.focus());
  const press = () => {
    add?.run();
    requestAnimationFrame(() => list.current?.lastElementChild?.querySelector<HTMLElement>("select")?.focus());
  };
  return (
    <>
      {items.length === 0 ? null : (
        <>
          {heads}
          <ul ref={list}>
            {items.map((item, at) => (
              <Row key={at} item={item} at={at} removed={removed} />
            ))}
          </ul>
        </>
      )}
      {add === null ? null : (
        <Button
          icon="plus"

          ref={button}
          testId={add.testId}
          disabled={!add.can}
          onClick={press}
        >
          {" "}
          {add.label}
        </Button>
      )}
    </>
  );
}

/** The end of a row. */
export function RemoveTool({ testId, label, onClick }: { testId: string; label: string; onClick: () => void }) {
  return (
    <span className="team-tools aligned">
      <Tool small icon="trash-2" label={label} testId={testId} data-what="remove" onClick={onClick} />
    </span>
  );
}
