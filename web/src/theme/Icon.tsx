/**
 * An icon by its lucide name, as robots and constructors name theirs in XML.
 *
 * Names of the bounded set are drawn at once. For another one a second, small set is fetched (once, from our own server), and
 * where it is not in that the whole one; until it is there, and for an unknown name, a plain square is drawn.
 */
import type { LucideIcon } from "lucide-react";
import { createElement, useEffect, useState } from "react";

import { ICONS } from "./icons";

interface IconProps {
  name: string;
  size?: number;
  /** The accessible name; without it the icon is decoration. */
  label?: string;
  className?: string;
}

const FALLBACK = "square-dashed";

type Icons = Readonly<Record<string, LucideIcon>>;

/** The sets that were fetched, by kebab-case and by PascalCase names. */
let more: Icons | null = null;
let all: Icons | null = null;
let loading: Promise<void> | null = null;
let loadingAll: Promise<void> | null = null;

function pascal(name: string): string {
  return name.replace(/(?:^|-)([a-z0-9])/g, (_, letter: string) => letter.toUpperCase());
}

/** Every lucide icon, from chunks of their own. */
export function loadIcons(): Promise<void> {
  loadingAll ??= Promise.all([loadMore(), import("./all-icons")]).then(
    ([, module]) => {
      all = module.ALL_ICONS;
    },
    () => {
      // Offline or cut off: the fallback stays.
      loadingAll = null;
    },
  );
  return loadingAll;
}

function loadMore(): Promise<void> {
  loading ??= import("./more-icons").then(
    (module) => {
      more = module.MORE_ICONS;
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

function known(name: string): LucideIcon | undefined {
  if (Object.hasOwn(ICONS, name)) return ICONS[name];
  return more !== null && Object.hasOwn(more, name) ? more[name] : all?.[pascal(name)];
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
  const drawn = found ?? ICONS[FALLBACK];
  if (drawn === undefined) return null;
  return createElement(drawn, {
    size,
    strokeWidth: size >= 20 ? 1.75 : 2,
    className: className ?? "",
    ...(label === undefined ? { "aria-hidden": true } : { role: "img", "aria-label": label }),
  });
}
