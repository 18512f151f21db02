// Loads MicroPython. A timer runs meanwhile: Node ends a thread or a process that waits for nothing but WebAssembly to
// be compiled (nodejs/node#36616), which on a busy machine takes long enough to be noticed.

const MANY_MS = 1_000_000;

export async function loaded(micropython, options) {
  const awake = setInterval(() => {}, MANY_MS);
  try {
    const { loadMicroPython } = await import(micropython);
    return await loadMicroPython(options);
  } finally {
    clearInterval(awake);
  }
}
