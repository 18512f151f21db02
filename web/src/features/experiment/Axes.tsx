/** What varies: each address with its values, and a field that finds another one. */
import { useId, useState } from "react";

import type { ExperimentChoices } from "../../api/generated";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { setValues, useVaried, vary, type VariedAxis, varyNoMore } from "../../session/varied-axes";
import { Button } from "../../ui/Button";
import { Tool } from "../../ui/Tool";

/** Addresses that the field offers at a time: a large mission has thousands. */
const MOST_OFFERED = 200;

export function Axes({ choices }: { choices: ExperimentChoices }) {
  const axes = useVaried((varied) => varied.axes);
  return (
    <fieldset>
      <legend className="muted small-text">{t("experiment.varies")}</legend>
      {axes.length === 0 ? <p className="prose muted">{t("experiment.nothing-varies")}</p> : null}
      <ul className="column">
        {axes.map((axis) => (
          <Axis key={axis.address} axis={axis} choices={choices} />
        ))}
      </ul>
      <AxisSearch choices={choices} />
    </fieldset>
  );
}

function Axis({ axis: { address, values }, choices }: { axis: VariedAxis; choices: ExperimentChoices }) {
  const known = choices.addresses.find((one) => one.address === address);
  const id = useId();
  return (
    <li className="experiment-axis">
      <code dir="ltr" className="ellipsis" title={address}>
        {address}
      </code>
      <input
        className="field"
        dir="ltr"
        maxLength={400}
        data-testid={`values-${address}`}
        aria-label={t("experiment.values-of", { address })}
        aria-describedby={id}
        placeholder={known?.example ?? ""}
        value={values}
        onChange={(event) => setValues(address, event.target.value)}
      />
      <Tool
        small
        icon="x"
        label={t("experiment.vary-no-more", { address })}
        testId={`vary-no-more-${address}`}
        onClick={() => varyNoMore(address)}
      />
      <span className="muted small-text experiment-axis-help" id={id}>
        {known === undefined ? (
          t("experiment.unknown")
        ) : (
          <Said
            text={
              known.current === ""
                ? known.expected
                : t("experiment.now", { now: known.current, expected: known.expected })
            }
          />
        )}
      </span>
    </li>
  );
}

function AxisSearch({ choices }: { choices: ExperimentChoices }) {
  const [typed, setTyped] = useState("");
  const id = useId();
  const wanted = typed.trim().toLowerCase();
  const found = choices.addresses.filter(({ address }) => address.toLowerCase().includes(wanted));
  const exact =
    found.find(({ address }) => address.toLowerCase() === wanted) ?? (found.length === 1 ? found[0] : undefined);
  const add = () => {
    if (exact === undefined || wanted === "") return;
    vary(exact.address);
    setTyped("");
  };
  return (
    <div className="row experiment-search">
      <input
        className="field"
        dir="ltr"
        list={id}
        maxLength={400}
        autoComplete="off"
        data-testid="experiment-address"
        aria-label={t("experiment.address")}
        placeholder={t("experiment.address")}
        value={typed}
        onChange={(event) => setTyped(event.target.value)}
        onKeyDown={(event) => {
          if (event.key !== "Enter") return;
          event.preventDefault();
          add();
        }}
      />
      <datalist id={id}>
        {found.slice(0, MOST_OFFERED).map(({ address }) => (
          <option key={address} value={address} />
        ))}
      </datalist>
      <Button icon="plus" testId="experiment-vary" disabled={exact === undefined || wanted === ""} onClick={add}>
        {t("experiment.vary")}
      </Button>
    </div>
  );
}
