/** A row of the palette: a part, the robot's object above its parts, or the way to a new variable. */
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import type { RobotObject } from "../../model/types";
import { valueWords } from "../../model/words";
import { openPartMenu } from "../../session/custom-blocks";
import { beginDrag, justDragged } from "../../session/drag";
import { addPart } from "../../session/edits";
import { useRun, watchedAgent } from "../../session/run";
import { newVariable, renameVariable, useVariables } from "../../session/variables";
import { Icon, Tile } from "../../theme";
import { onLongPress } from "../../ui/long-press";
import { actionsOf, removableProps } from "./row-actions";
import type { Row } from "./tree";
import { VariableName } from "./VariableName";

interface RowProps {
  row: Row;
  robot: string;
  focused: boolean;
  onFocus: () => void;
  /** A variable's name was typed over, or stays as it is. */
  onNamed: (name: string) => void;
}

export function PaletteRow({ row, robot, focused, onFocus, onNamed }: RowProps) {
  const level = row.kind === "part" ? row.level : 1;
  const common = {
    role: "treeitem",
    "aria-level": level,
    "data-row": row.key,
    "data-level": level,
    tabIndex: focused ? 0 : -1,
    onFocus,
  };
  if (row.kind === "new") {
    return (
      <div
        {...common}
        className="palette-part palette-new row muted hover"
        data-testid="new-variable"
        onClick={() => newVariable()}
      >
        <Icon name="plus" size={16} />
        <span className="palette-name grow breakable">{row.label}</span>
      </div>
    );
  }
  if (row.kind === "object") return <ObjectRow {...{ row, robot, common, onNamed }} />;
  const { shape } = row;
  const actions = actionsOf(row, robot);
  const icon = shape.method === null ? shape.icon : shape.method.icon || shape.icon;
  return (
    <div
      {...common}
      className="palette-part row hover"
      data-testid={`part-${shape.element}`}
      title={text(shape.help)}
      {...(actions === null ? {} : removableProps(actions))}
      onPointerDown={(event) => {
        beginDrag(event, { kind: "part", element: shape.element });
        if (actions !== null) onLongPress(event, actions.openMenu);
      }}
      onClick={() => {
        if (!justDragged()) addPart(shape.element);
      }}
    >
      <Tile icon={icon} colour={shape.colour} size={22} />
      <span className="palette-name grow breakable">{row.label}</span>
      {row.aside === "" ? null : <span className="palette-aside ellipsis muted rigid tiny-text">{row.aside}</span>}
      {actions !== null ? <CustomBlockMore name={shape.element} /> : null}
    </div>
  );
}

interface ObjectProps {
  row: Extract<Row, { kind: "object" }>;
  robot: string;
  common: Record<string, unknown>;
  onNamed: (name: string) => void;
}

function ObjectRow({ row, robot, common, onNamed }: ObjectProps) {
  const renaming = useVariables((state) => state.renaming);
  const { object } = row;
  const variable = object.category === "variable" ? { robot, name: object.name } : null;
  const actions = actionsOf(row, robot);
  return (
    <div
      {...common}
      {...(actions === null ? {} : removableProps(actions))}
      {...(variable === null ? {} : { onDoubleClick: () => renameVariable(variable) })}
      onPointerDown={(event) => actions !== null && onLongPress(event, actions.openMenu)}
      className="palette-object row bold"
      data-testid={`object-${object.name}`}
    >
      <Icon name={iconOf(object)} size={14} />
      {variable !== null && renaming?.name === variable.name && renaming.robot === robot ? (
        <VariableName of={variable} done={onNamed} />
      ) : (
        <span className="palette-name grow breakable">{row.label}</span>
      )}
      <Live object={object} />
    </div>
  );
}

/** A variable of the mission has no icon of its own. */
function iconOf({ icon, category, type }: RobotObject): string {
  return icon !== "" || category !== "variable" ? icon : type === "boolean" ? "toggle-right" : "hash";
}

/** What a sensor or variable of the watched agent says now, while a run exists. */
function Live({ object }: { object: RobotObject }) {
  const program = useStudio((state) => state.activeProgram);
  const value = useRun((state) => {
    if (object.category === "actuator") return undefined;
    const agent = watchedAgent(state, program);
    return object.category === "sensor" ? agent?.inputs[object.name] : agent?.values[object.name];
  });
  if (value === undefined) return null;
  return <span className="palette-live rigid nowrap tiny-text">{valueWords(object, value)}</span>;
}

/** The button at the end of a part's row that opens its menu; keys open it from the row itself. */
function CustomBlockMore({ name }: { name: string }) {
  return (
    <button
      type="button"
      className="own-more tool small muted rigid to-end"
      tabIndex={-1}
      aria-label={t("own.menu", { name })}
      title={t("own.menu", { name })}
      onPointerDown={(event) => event.stopPropagation()}
      onClick={(event) => {
        event.stopPropagation();
        const box = event.currentTarget.getBoundingClientRect();
        openPartMenu(name, box.left, box.bottom);
      }}
    >
      <Icon name="ellipsis" size={16} />
    </button>
  );
}
