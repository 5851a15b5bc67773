c     Compressible neo-Hookean rubber: sigma = (mu (B - 1) + lambda ln(J) 1) / J, B = U U in the frame that turns with the
c     material (Bonet and Wood, Nonlinear Continuum Mechanics, section 6.4.3).
c     PROPS: Young's modulus, Poisson's ratio. STATEV: ln(J).
      subroutine vumat(
     1  nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal,
     2  stepTime, totalTime, dt, cmname, coordMp, charLength,
     3  props, density, strainInc, relSpinInc,
     4  tempOld, stretchOld, defgradOld, fieldOld,
     5  stressOld, stateOld, enerInternOld, enerInelasOld,
     6  tempNew, stretchNew, defgradNew, fieldNew,
     7  stressNew, stateNew, enerInternNew, enerInelasNew)
      include 'vaba_param.inc'
      dimension props(nprops), density(nblock), coordMp(nblock,*),
     1  charLength(nblock), strainInc(nblock,ndir+nshr),
     2  relSpinInc(nblock,nshr), tempOld(nblock),
     3  stretchOld(nblock,ndir+nshr), defgradOld(nblock,ndir+2*nshr),
     4  fieldOld(nblock,nfieldv), stressOld(nblock,ndir+nshr),
     5  stateOld(nblock,nstatev), enerInternOld(nblock),
     6  enerInelasOld(nblock), tempNew(nblock),
     7  stretchNew(nblock,ndir+nshr), defgradNew(nblock,ndir+2*nshr),
     8  fieldNew(nblock,nfieldv), stressNew(nblock,ndir+nshr),
     9  stateNew(nblock,nstatev), enerInternNew(nblock),
     1  enerInelasNew(nblock)
      character*80 cmname
      e = props(1)
      xnu = props(2)
      xmu = e / (2.d0 * (1.d0 + xnu))
      xlambda = 2.d0 * xmu * xnu / (1.d0 - 2.d0 * xnu)
      do k = 1, nblock
        u11 = stretchNew(k,1)
        u22 = stretchNew(k,2)
        u33 = stretchNew(k,3)
        u12 = stretchNew(k,4)
        u23 = stretchNew(k,5)
        u31 = stretchNew(k,6)
        xj = u11 * (u22 * u33 - u23 * u23)
     1     - u12 * (u12 * u33 - u23 * u31)
     2     + u31 * (u12 * u23 - u22 * u31)
        xlog = log(xj)
        stressNew(k,1) = (xmu * (u11*u11 + u12*u12 + u31*u31 - 1.d0)
     1                  + xlambda * xlog) / xj
        stressNew(k,2) = (xmu * (u12*u12 + u22*u22 + u23*u23 - 1.d0)
     1                  + xlambda * xlog) / xj
        stressNew(k,3) = (xmu * (u31*u31 + u23*u23 + u33*u33 - 1.d0)
     1                  + xlambda * xlog) / xj
        stressNew(k,4) = xmu * (u11*u12 + u12*u22 + u31*u23) / xj
        stressNew(k,5) = xmu * (u12*u31 + u22*u23 + u23*u33) / xj
        stressNew(k,6) = xmu * (u11*u31 + u12*u23 + u31*u33) / xj
        if (nstatev .gt. 0) stateNew(k,1) = xlog
      end do
      return
      end
