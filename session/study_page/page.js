"use strict";
// Two-alternative forced choice: every pair twice with sides swapped, in an order of the participant's own.
(() => {
  const $ = (id) => document.getElementById(id);
  const study = JSON.parse($("study").textContent);
  const total = 2 * study.pairs.length;

  // The numbers of core/rng.h: the n-th of a seed.
  const wrap = (z) => BigInt.asUintN(64, z);
  const mix = (z) => {
    z = wrap((z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n);
    z = wrap((z ^ (z >> 27n)) * 0x94d049bb133111ebn);
    return z ^ (z >> 31n);
  };
  const kGolden = 0x9e3779b97f4a7c15n;
  const indices = (seed) => {
    const key = mix(wrap(seed + kGolden * (mix(0x632be59bd9b4e019n) | 1n)));
    let counter = 0n;
    return (n) => Number(((mix(wrap(key + kGolden * ++counter)) >> 32n) * BigInt(n)) >> 32n);
  };

  // Any order is as likely as any other, but for those in which the two showings of a pair follow each other: these are
  // drawn again (a single pair has no other).
  const orderOf = (id) => {
    const index = indices(BigInt("0x" + id));
    const trials = study.pairs.flatMap((_, pair) => [{pair, human: "left"}, {pair, human: "right"}]);
    const shuffle = () => {
      for (let i = trials.length - 1; i > 0; --i) {
        const k = index(i + 1);
        [trials[i], trials[k]] = [trials[k], trials[i]];
      }
    };
    const repeats = () => trials.some((trial, i) => i > 0 && trial.pair === trials[i - 1].pair);
    shuffle();
    for (let tries = 0; tries < 1000 && repeats(); ++tries) shuffle();
    return trials;
  };

  const storeName = "inhabit-study-" + study.study;
  let kept = true;
  let state = {current: null, done: []};
  const load = () => {
    try {
      const text = localStorage.getItem(storeName);
      if (text !== null) state = JSON.parse(text);
    } catch {
      kept = false;
    }
  };
  const keep = () => {
    try {
      localStorage.setItem(storeName, JSON.stringify(state));
    } catch {
      kept = false;
    }
  };

  const hex = (bytes) => Array.from(bytes, (b) => b.toString(16).padStart(2, "0")).join("");
  const freshId = () => hex(crypto.getRandomValues(new Uint8Array(6)));
  let order = [];
  const begin = (id) => {
    state.current = {id, answers: []};
    order = orderOf(id);
  };

  const pages = ["intro", "trial", "grey", "end"];
  let page = "";
  const show = (name) => {
    page = name;
    for (const id of pages) $(id).hidden = id !== name;
  };

  const picture = (index) => {
    const image = document.createElement("img");
    image.alt = "";
    image.draggable = false;
    image.src = study.pictures[index];
    return image;
  };
  const decoded = (image) => (image.decode ? image.decode().catch(() => {}) : Promise.resolve());

  let shownAt = 0;
  let saved = true;
  const answered = () => state.current.answers.length;

  const trial = async () => {
    const at = order[answered()];
    const pair = study.pairs[at.pair];
    const plates = {human: pair.human.map(picture), other: pair.pictures.map(picture)};
    const wait = new Promise((done) => setTimeout(done, 1000 * study.grey));
    await Promise.all([wait, ...plates.human.map(decoded), ...plates.other.map(decoded)]);
    const left = at.human === "left";
    $("left").replaceChildren(...(left ? plates.human : plates.other));
    $("right").replaceChildren(...(left ? plates.other : plates.human));
    const number = answered() + 1;
    $("pair").textContent = `Pair ${number} of ${total}: which do you prefer?`;
    $("left").setAttribute("aria-label", "The left arrangement");
    $("right").setAttribute("aria-label", "The right arrangement");
    $("bar").max = total;
    $("bar").value = answered();
    show("trial");
    $("pair").focus({preventScroll: true});
    shownAt = performance.now();
  };

  const proceed = () => {
    if (answered() >= order.length) return end();
    show("grey");
    return trial();
  };

  const choose = (side) => {
    if (page !== "trial") return;
    const at = order[answered()];
    const pair = study.pairs[at.pair];
    const seconds = Math.round(performance.now() - shownAt) / 1000;
    state.current.answers.push({scene: pair.scene, synthesis: pair.synthesis, human: at.human, chosen: side, seconds});
    saved = false;
    keep();
    proceed();
  };

  const everybody = () => [...state.done, state.current].filter((person) => person.answers.length > 0);
  const answersText = () =>
    JSON.stringify({format: "inhabit-answers", version: 1, study: study.study, title: study.title, participants: everybody()},
      null, 1) + "\n";

  const end = () => {
    const count = everybody().length;
    $("people").textContent = count === 1 ? "One participant has answered on this computer." :
      `${count} participants have answered on this computer; the file holds them all.`;
    $("text").value = answersText();
    $("saved").textContent = "";
    show("end");
    $("thanks").focus();
  };

  const save = () => {
    const url = URL.createObjectURL(new Blob([answersText()], {type: "application/json"}));
    const link = document.createElement("a");
    link.href = url;
    link.download = `answers-${state.current.id}.json`;
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
    saved = true;
    $("saved").textContent = `Saved as ${link.download}, where your browser puts downloads.`;
  };

  const intro = () => {
    $("title").textContent = study.title;
    $("task").replaceChildren(...study.task.split(/\n\s*\n/).map((text) => {
      const paragraph = document.createElement("p");
      paragraph.textContent = text;
      return paragraph;
    }));
    for (const span of document.querySelectorAll(".total")) span.textContent = total;
    const begun = answered() > 0;
    $("start").textContent = begun ? "Continue" : "Begin";
    $("progress-kept").hidden = !begun;
    $("progress-kept").textContent = `You have answered ${answered()} of ${total} pairs; it goes on where you stopped.`;
    keep();
    $("not-kept").hidden = kept;
    show("intro");
    $("start").focus();
  };

  $("start").addEventListener("click", proceed);
  $("left").addEventListener("click", () => choose("left"));
  $("right").addEventListener("click", () => choose("right"));
  $("save").addEventListener("click", save);
  $("next").addEventListener("click", () => {
    if (!kept && !saved && !confirm("The answers are not saved yet. Go on?")) return;
    state.done.push(state.current);
    begin(freshId());
    intro();
  });
  $("clear").addEventListener("click", () => {
    if (!confirm("Delete the answers of everybody on this computer?")) return;
    state = {current: null, done: []};
    saved = true;
    begin(freshId());
    intro();
  });
  const sides = {ArrowLeft: "left", 1: "left", ArrowRight: "right", 2: "right"};
  document.addEventListener("keydown", (event) => {
    if (event.repeat || event.ctrlKey || event.altKey || event.metaKey || page !== "trial") return;
    const side = sides[event.key];
    if (side === undefined) return;
    event.preventDefault();
    choose(side);
  });
  window.addEventListener("beforeunload", (event) => {
    if (!kept && !saved) event.preventDefault();
  });

  load();
  const asked = /^#seed=([0-9a-f]{1,12})$/.exec(location.hash);
  if (state.current === null || (answered() === 0 && asked)) begin(asked ? asked[1].padStart(12, "0") : freshId());
  order = orderOf(state.current.id);
  if (answered() >= total) end();
  else intro();
})();
