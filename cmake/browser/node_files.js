// Before programs for node begin: -sNODERAWFS of Emscripten 3.1.6 hands a file's times to node in milliseconds, which
// node takes for seconds.
{
  const fs = require('fs');
  const setTimes = fs.utimesSync;
  fs.utimesSync = (path, accessed, modified) => setTimes(path, accessed / 1000, modified / 1000);
}
