/** Marks a number to vary in an experiment, and says beside it which values it takes there. */
import { t } from "../../i18n/words";
import { useShown } from "../../session/simple-view";
import { toggleVaried, useVaried } from "../../session/varied";

export function VaryButton({ address, name }: { address: string; name: string }) {
  const axis = useVaried(({ axes }) => axes.find((one) => one.address === address));
  if (!useShown("verification")) return null;
  return (
    <div className="row small-text justify-end">
      <button
        type="button"
        className="inspector-vary-button finger muted boxed"
        aria-pressed={axis !== undefined}
        title={t("experiment.vary-part")}
        aria-label={t(axis === undefined ? "experiment.vary-field" : "experiment.varied-field", { name })}
        data-testid={`vary-${address}`}
        onClick={() => toggleVaried(address)}
      >
        {t("experiment.vary")}
      </button>
      {axis === undefined || axis.values === "" ? null : <code dir="ltr">{axis.values}</code>}
    </div>
  );
}
