// A worker answers the questions of the page, one after the other.
"use strict";

let asked = null;
const waiting = [];

function answer({ id, question }) {
  try {
    postMessage({ id, ok: asked(question) });
  } catch (error) {
    postMessage({ id, error: error.message });
  }
}

onmessage = async ({ data }) => {
  if (data.module) {
    asked = await load(data.module);
    waiting.splice(0).forEach(answer);
  } else if (asked) {
    answer(data);
  } else {
    waiting.push(data);
  }
};
