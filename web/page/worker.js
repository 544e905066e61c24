// A worker answers the questions of the page, one after the other.
"use strict";

let asked = null;
const waiting = [];

// A file is read here, and a table becomes one, so that the page does not wait.
async function answer({ id, question: { file, ...question } }) {
  try {
    if (file) question[question.ask === "system" ? "record" : "text"] = await file.text();
    const ok = asked(question);
    postMessage({ id, ok: question.ask === "record-table" ? new Blob([csvText(ok)]) : ok });
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
