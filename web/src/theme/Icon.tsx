/**
 * An icon by its lucide name, as robots and constructors name theirs in XML.
 *
 * Names of the bounded set are drawn at once. For another one a second, small set is fetched (once, from our own server), and
 * where it is not in that the whole one; until it is there, and for an unknown name, a plain square is drawn.
 */
import { createElement, useEffect, useState } from "react";

import ICONS from "./icons.lucide";

interface IconProps {
  name: string;
  size?: number;
  /** The accessible name; without it the icon is decoration. */
  label?: string;
  className?: string;
}

const FALLBACK = "square-dashed";

/** The sets that were fetched. */
let more: typeof ICONS | null = null;
let all: typeof ICONS | null = null;
let loading: Promise<void> | null = null;
let loadingAll: Promise<void> | null = null;

/** Every lucide icon, from chunks of their own. */
export function loadIcons(): Promise<void> {
  loadingAll ??= Promise.all([loadMore(), import("./all.lucide")]).then(
    ([, module]) => {
      all = module.default;
    },
    () => {
      // Offline or cut off: the fallback stays.
      loadingAll = null;
    },
  );
  return loadingAll;
}

function loadMore(): Promise<void> {
  loading ??= import("./more.lucide").then(
    (module) => {
      more = module.default;
    },
    () => {
      loading = null;
    },
  );
  return loading;
}

async function load(name: string): Promise<void> {
  await loadMore();
  if (known(name) === undefined) await loadIcons();
}

function known(name: string): (typeof ICONS)[string] | undefined {
  return [ICONS, more, all].find((icons) => icons !== null && Object.hasOwn(icons, name))?.[name];
}

export function Icon({ name, size = 16, label, className }: IconProps) {
  const [, setLoaded] = useState(0);
  const found = known(name);
  const missing = found === undefined && name !== "" && all === null;
  useEffect(() => {
    if (!missing) return;
    let alive = true;
    void load(name).then(() => {
      if (alive) setLoaded((n) => n + 1);
    });
    return () => {
      alive = false;
    };
  }, [missing, name]);
  const shown = found === undefined ? FALLBACK : name;
  return (
    <svg
      xmlns="http://www.w3.org/2000/svg"
      width={size}
      height={size}
      viewBox="0 0 24 24"
      fill="none"
      stroke="currentColor"
      strokeWidth={size >= 20 ? 1.75 : 2}
      strokeLinecap="round"
      strokeLinejoin="round"
      className={`lucide lucide-${shown} ${className ?? ""}`.trim()}
      {...(label === undefined ? { "aria-hidden": true } : { role: "img", "aria-label": label })}
    >
      {known(shown)?.map(([tag, attributes], at) => createElement(tag, { key: at, ...attributes }))}
    </svg>
  );
}
