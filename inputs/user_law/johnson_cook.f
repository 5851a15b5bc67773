c     Yield stress of Johnson and Cook, (A + B p^n) (1 + C ln r) (1 - t^m), r = rate / reference, at least 1, and
c     t = (T - T_room) / (T_melt - T_room) between 0 and 1, with the temperature at the end of the step.
c     PROPS: A, B, n, C, m, melting temperature, room temperature, reference rate.
c     STATEV, if there is one: t.
      subroutine vuhard(
     1  nblock, jElem, kIntPt, kLayer, kSecPt,
     2  lAnneal, stepTime, totalTime, dt, cmname,
     3  nstatev, nfieldv, nprops,
     4  props, tempOld, tempNew, fieldOld, fieldNew,
     5  stateOld, eqps, eqpsRate,
     6  yield, dyieldDtemp, dyieldDeqps, stateNew)
      include 'vaba_param.inc'
      dimension jElem(nblock), props(nprops), tempOld(nblock),
     1  tempNew(nblock), fieldOld(nblock,nfieldv),
     2  fieldNew(nblock,nfieldv), stateOld(nblock,nstatev),
     3  eqps(nblock), eqpsRate(nblock), yield(nblock),
     4  dyieldDtemp(nblock), dyieldDeqps(nblock,2),
     5  stateNew(nblock,nstatev)
      character*80 cmname
      a = props(1)
      b = props(2)
      xn = props(3)
      c = props(4)
      xm = props(5)
      span = props(6) - props(7)
      do k = 1, nblock
        p = max(eqps(k), 1.d-10)
        atRest = a + b * p**xn
        slope = b * xn * p**(xn - 1.d0)
        rate = eqpsRate(k) / props(8)
        faster = 1.d0
        byRate = 0.d0
        if (rate .gt. 1.d0) then
          faster = 1.d0 + c * log(rate)
          byRate = c / eqpsRate(k)
        end if
        t = min(max((tempNew(k) - props(7)) / span, 0.d0), 1.d0)
        softer = 1.d0 - t**xm
        byTemp = 0.d0
        if (t .gt. 0.d0) byTemp = -xm * t**(xm - 1.d0) / span
        yield(k) = atRest * faster * softer
        dyieldDtemp(k) = atRest * faster * byTemp
        dyieldDeqps(k,1) = slope * faster * softer
        dyieldDeqps(k,2) = atRest * byRate * softer
        if (nstatev .gt. 0) stateNew(k,1) = t
      end do
      return
      end
