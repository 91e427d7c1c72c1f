// Clicks through the page of a study without a browser: `node study_page_test.js PAGE`. What of a browser the page
// needs is below, as small as it can be; answers go to standard output.
"use strict";
const assert = require("node:assert");
const fs = require("node:fs");
const vm = require("node:vm");

const html = fs.readFileSync(process.argv[2], "utf8");
const data = html.match(/<script type="application\/json" id="study">(.*?)<\/script>/s)[1];
const script = html.match(/<script>\n(.*?)<\/script>/s)[1];
const study = JSON.parse(data);
const total = 2 * study.pairs.length;

class Element {
  constructor(tag) {
    Object.assign(this, {tag, hidden: true, textContent: "", children: [], attributes: {}, listeners: {}});
  }
  addEventListener(type, f) { this.listeners[type] = f; }
  setAttribute(name, value) { this.attributes[name] = value; }
  replaceChildren(...children) { this.children = children; }
  append() {}
  remove() {}
  focus() { Element.focused = this; }
  click() { if (this.tag === "a") downloads.push(this.download); else this.listeners.click(); }
}
const downloads = [];

/// The page opened afresh; `storage` is what the browser kept.
const open = (storage, hash = "") => {
  const ids = Object.fromEntries([...html.matchAll(/<(\w+)[^>]*\bid="([-\w]+)"/g)].map((m) => [m[2], new Element(m[1])]));
  ids.study.textContent = data;
  const timers = [], listeners = {};
  let clock = 0, blob = "";
  const context = {
    document: {getElementById: (id) => ids[id], createElement: (tag) => new Element(tag), querySelectorAll: () => [],
      addEventListener: (type, f) => { listeners[type] = f; }, body: new Element("body")},
    window: {addEventListener: () => {}},
    localStorage: {getItem: (k) => { if (!storage) throw Error("no"); return storage[k] ?? null; },
      setItem: (k, v) => { if (!storage) throw Error("no"); storage[k] = v; }},
    location: {hash}, performance: {now: () => (clock += 1500)}, crypto: globalThis.crypto, confirm: () => true,
    setTimeout: (f, ms) => timers.push([f, ms]), URL: {createObjectURL: () => "blob:", revokeObjectURL: () => {}},
    Blob: class { constructor(parts) { blob = parts.join(""); } },
  };
  vm.runInNewContext(script, context);
  const settle = async () => { for (let i = 0; i < 10; ++i) await Promise.resolve(); };
  return {
    ids, shown: () => ["intro", "trial", "grey", "end"].filter((id) => !ids[id].hidden).join(), blob: () => blob,
    grey: async () => {
      const [[f, ms]] = timers.splice(0);
      assert.strictEqual(ms, 1000 * study.grey);
      f();
      await settle();
    },
    key: (key, more = {}) => listeners.keydown({key, preventDefault() {}, ...more}),
  };
};

/// Pictures of both sides, as numbers.
const sides = (p) => ["left", "right"].map((id) => p.ids[id].children.map((image) => study.pictures.indexOf(image.src)));

/// Answers `count` pairs, always for the human design where `loyal`, else always left; checks what is shown.
const answer = async (p, count, loyal, seen) => {
  for (let i = 0; i < count; ++i) {
    assert.strictEqual(p.shown(), "grey");
    p.key("ArrowLeft");  // nobody answers a grey page
    await p.grey();
    assert.strictEqual(p.shown(), "trial");
    assert.match(p.ids.pair.textContent, new RegExp(`^Pair ${seen.length + 1} of ${total}:`));
    assert.strictEqual(Element.focused, p.ids.pair);
    const [left, right] = sides(p).map(String);
    const k = study.pairs.findIndex((pair) => [left, right].sort().join("|") === [pair.human, pair.pictures].map(String).sort().join("|"));
    assert.ok(k >= 0, "plates of no pair");
    const human = String(study.pairs[k].human) === left ? "left" : "right";
    seen.push(`${k} ${human}`);
    const choice = loyal ? human : "left";
    p.key("ArrowLeft", {repeat: true});
    p.key("x");
    assert.strictEqual(p.shown(), "trial");
    if (i % 2) p.ids[choice].click();
    else p.key(choice === "left" ? "ArrowLeft" : "2");
  }
};

(async () => {
  const storage = {}, seen = [];
  let p = open(storage, "#seed=12ab");
  assert.strictEqual(p.shown(), "intro");
  assert.strictEqual(p.ids.start.textContent, "Begin");
  assert.ok(p.ids["not-kept"].hidden);
  p.ids.start.click();
  await answer(p, 3, true, seen);
  // A reload loses nothing.
  p = open(storage, "#seed=12ab");
  assert.strictEqual(p.ids.start.textContent, "Continue");
  p.ids.start.click();
  await answer(p, total - 3, true, seen);
  assert.strictEqual(p.shown(), "end");
  assert.strictEqual(new Set(seen).size, total, "every pair on both sides");
  if (study.pairs.length > 1)
    for (let i = 1; i < total; ++i) assert.notStrictEqual(seen[i].split(" ")[0], seen[i - 1].split(" ")[0]);
  assert.strictEqual(open(storage).shown(), "end");
  // The same seed gives the same order, another one another.
  const again = [], other = [];
  for (const [list, seed] of [[again, "12ab"], [other, "12ac"]]) {
    const q = open({}, "#seed=" + seed);
    q.ids.start.click();
    await answer(q, total, true, list);
  }
  assert.deepStrictEqual(again, seen);
  if (total > 6) assert.notDeepStrictEqual(other, seen);
  // The next one at the same computer; both are in the file.
  p.ids.next.click();
  assert.strictEqual(p.shown(), "intro");
  p.ids.start.click();
  await answer(p, total, false, []);
  p.ids.save.click();
  assert.strictEqual(downloads.length, 1);
  assert.match(downloads[0], /^answers-[0-9a-f]{12}\.json$/);
  assert.strictEqual(p.blob(), p.ids.text.value);
  const file = JSON.parse(p.blob());
  assert.deepStrictEqual(file.participants.map((person) => person.answers.length), [total, total]);
  assert.strictEqual(file.participants[0].id, "0000000012ab");
  assert.ok(file.participants[0].answers.every((a) => a.human === a.chosen && a.seconds === 1.5));
  // A browser that keeps nothing says so and works.
  const q = open(null);
  assert.ok(!q.ids["not-kept"].hidden);
  q.ids.start.click();
  await answer(q, total, true, []);
  assert.strictEqual(q.shown(), "end");
  p.ids.clear.click();
  assert.strictEqual(p.shown(), "intro");
  process.stdout.write(p.blob() || JSON.stringify(file));
})().catch((error) => {
  console.error(error);
  process.exitCode = 1;
});
