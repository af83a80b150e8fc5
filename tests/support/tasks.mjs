// How long the threads of a page are busy, from the browser's traces.

/**
 * The tasks of the page during `act`: `page`, those of the page's thread, the longest first, and `all`, those of all threads of
 * its process. Each has the milliseconds of processor time in `busy`, and of wall time in `wall`.
 */
export async function tasksDuring(browser, page, act) {
  await browser.startTracing(page, { categories: ["toplevel", "devtools.timeline", "__metadata"] });
  await act();
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const main = traceEvents.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const threads = new Set(main.map(({ pid, tid }) => `${pid} ${tid}`));
  const processes = new Set(main.map(({ pid }) => pid));
  const events = traceEvents
    .filter(({ name, ph, pid }) => ph === "X" && name.endsWith("RunTask") && processes.has(pid))
    .sort((a, b) => (b.tdur ?? b.dur) - (a.tdur ?? a.dur));
  const tasks = (list) => list.map(({ dur, tdur }) => ({ wall: dur / 1000, busy: (tdur ?? dur) / 1000 }));
  return { page: tasks(events.filter(({ pid, tid }) => threads.has(`${pid} ${tid}`))), all: tasks(events) };
}

/** The processor time of tasks in milliseconds. */
export const busy = (tasks) => tasks.reduce((sum, task) => sum + task.busy, 0);
