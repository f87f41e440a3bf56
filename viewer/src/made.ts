// SPDX-License-Identifier: MIT
/** What is made when it is first asked for, and kept. */

/** What a map has under a key; what `make` gives, if there is nothing so far. */
export function made<K, V>(map: Pick<Map<K, V>, 'get'> & { set(key: K, value: V): unknown }, key: K, make: () => V): V {
  let value = map.get(key);
  if (value === undefined) map.set(key, (value = make()));
  return value;
}
