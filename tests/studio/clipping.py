"""Measures what a reader sees of every text of a page: what is cut off, what lies over another."""

from __future__ import annotations

from playwright.sync_api import Page

_MEASURE = """() => {
    const free = document.createElement('style');
    free.textContent = '* { pointer-events: auto !important }';
    document.head.append(free);
    const meet = (p, q) => ({ left: Math.max(p.left, q.left), right: Math.min(p.right, q.right),
        top: Math.max(p.top, q.top), bottom: Math.min(p.bottom, q.bottom) });
    const is = (box) => box.right - box.left > 2 && box.bottom - box.top > 3;
    const window_ = { left: 0, right: innerWidth, top: 0, bottom: innerHeight };
    const styles = new Map();
    const style = (one) => styles.get(one) ?? styles.set(one, getComputedStyle(one)).get(one);
    const short = (text) => JSON.stringify(text.replace(/\\s+/g, ' ').trim().slice(0, 40));
    const name = (one) => one.closest('[data-testid]')?.dataset.testid ?? '';
    const found = new Set();
    const texts = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
        const parent = node.parentElement;
        if (node.data.trim() === '' || !parent.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
        if (parent.closest('script, style, option, title, metadata, [hidden]') !== null) continue;
        const range = document.createRange();
        range.selectNodeContents(node);
        for (const rect of range.getClientRects()) {
            let box = { left: rect.left, right: rect.right, top: rect.top, bottom: rect.bottom };
            if (!is(box)) continue;
            // A line is taller than its letters.
            const spare = Math.min(box.bottom - box.top - 4, 6) / 2;
            box.top += spare; box.bottom -= spare;
            let scrolls = false, told = false, hidden = false;
            for (let one = parent; one !== null && one !== document.documentElement; one = one.parentElement) {
                const { overflowX, overflowY, display, position, textOverflow, webkitLineClamp, clipPath } = style(one);
                if (clipPath !== 'none') { const b = one.getBoundingClientRect(); if (b.width <= 2 || b.height <= 2) hidden = true; }
                if (textOverflow === 'ellipsis' || webkitLineClamp !== 'none') told = true;
                if (display !== 'inline' && (overflowX !== 'visible' || overflowY !== 'visible')) {
                    const border = one.getBoundingClientRect();
                    if (border.width <= 2 || border.height <= 2) { hidden = true; break; }
                    const inside = { ...box };
                    if (overflowX !== 'visible') { inside.left = Math.max(box.left, border.left); inside.right = Math.min(box.right, border.right); }
                    if (overflowY !== 'visible') { inside.top = Math.max(box.top, border.top); inside.bottom = Math.min(box.bottom, border.bottom); }
                    const pans = one.matches('.react-flow, .react-flow *, [data-pans]');
                    const x = /auto|scroll/.test(overflowX) || pans, y = /auto|scroll/.test(overflowY) || pans;
                    const lost = (!x && (inside.left - box.left > 1.5 || box.right - inside.right > 1.5))
                        || (!y && (inside.top - box.top > 1.5 || box.bottom - inside.bottom > 1.5));
                    if (lost && !told && !scrolls) found.add(`${short(node.data)} in ${name(parent)} is cut by ${name(one)} ${one.className}`);
                    if (x || y) scrolls = true;
                    box = inside;
                    if (!is(box)) { hidden = true; break; }
                }
                if (position === 'fixed') break;
            }
            if (hidden) continue;
            const seen = meet(box, window_);
            if (!scrolls && (box.left < -1 || box.right > innerWidth + 1 || box.top < -1 || box.bottom > innerHeight + 1))
                found.add(`${short(node.data)} in ${name(parent)} is out of the window`);
            if (is(seen)) texts.push({ node, parent, box: seen });
        }
    }
    const opaque = (one) => {
        const alpha = style(one).backgroundColor.match(/[\\d.]+/g) ?? [];
        return (alpha.length === 3 || Number(alpha[3] ?? 0) > 0.85) || style(one).backgroundImage !== 'none';
    };
    const shows = (parent, x, y) => {
        for (const one of document.elementsFromPoint(x, y)) {
            if (one === parent || parent.contains(one)) return true;
            if (one.contains(parent)) return true;
            if (opaque(one) || one.tagName === 'CANVAS') return false;
        }
        return false;
    };
    texts.sort((p, q) => p.box.left - q.box.left);
    for (let a = 0; a < texts.length; a++) for (let b = a + 1; b < texts.length && texts[b].box.left < texts[a].box.right; b++) {
        const [p, q] = [texts[a], texts[b]];
        if (p.node === q.node) continue;
        const both = meet(p.box, q.box);
        if (!is(both)) continue;
        const [x, y] = [(both.left + both.right) / 2, (both.top + both.bottom) / 2];
        if (shows(p.parent, x, y) && shows(q.parent, x, y))
            found.add(`${short(p.node.data)} in ${name(p.parent)} and ${short(q.node.data)} in ${name(q.parent)} lie over each other`);
    }
    free.remove();
    return [...found];
}"""


def amiss(page: Page) -> list[str]:
    """What is amiss with the texts that are seen now, one sentence each."""
    found: list[str] = page.evaluate(_MEASURE)
    return found
